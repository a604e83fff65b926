// Compiled once for every instruction set, with BRECCIA_KERNEL_TABLE naming the table it fills and
// BRECCIA_REGISTER_LANES the doubles that a register holds. Everything here has internal linkage and nothing of the
// standard library is used, so that no code for a newer processor leaks into others.

#include "cell_row_kernel.hpp"

namespace breccia::dynamics {
namespace {

constexpr int width = BRECCIA_REGISTER_LANES;  ///< cells in a register; a block takes lanes / width of them
constexpr int parts = lanes / width;

typedef double Pack __attribute__((vector_size(width * sizeof(double))));        // NOLINT(modernize-use-using)
typedef long long Bits __attribute__((vector_size(width * sizeof(long long))));  // NOLINT(modernize-use-using)

#define BRECCIA_INLINE inline __attribute__((always_inline))

BRECCIA_INLINE Pack load(const double* from) {
  Pack pack;
  __builtin_memcpy(&pack, from, sizeof(pack));
  return pack;
}

BRECCIA_INLINE void store(double* to, const Pack& pack) {
  __builtin_memcpy(to, &pack, sizeof(pack));
}

/// Strain modes of the cells of a register, times the cell side.
struct Modes {
  Pack xx, yy, xy;  ///< of the centre; xy is the engineering shear
  Pack qu, qv;      ///< hourglass modes
};

/// Volumetric strain modes of the cells of a register, times the cell side.
struct VolumeModes {
  Pack centre, qu, qv;
};

/// Theory, Eq. 6: nodes in the order lower left, lower right, upper left, upper right.
BRECCIA_INLINE Modes strain_modes(const NodeValues& below, const NodeValues& above, int cell) {
  const Pack u00 = load(below.x + cell), u10 = load(below.x + cell + 1);
  const Pack u01 = load(above.x + cell), u11 = load(above.x + cell + 1);
  const Pack v00 = load(below.y + cell), v10 = load(below.y + cell + 1);
  const Pack v01 = load(above.y + cell), v11 = load(above.y + cell + 1);
  const Pack ux0 = u10 - u00, ux1 = u11 - u01;
  const Pack vx0 = v10 - v00, vx1 = v11 - v01;
  const Pack uy = (u01 - u00) + (u11 - u10);
  const Pack vy = (v01 - v00) + (v11 - v10);
  return {0.5 * (ux0 + ux1), 0.5 * vy, 0.5 * (uy + (vx0 + vx1)), ux1 - ux0, vx1 - vx0};
}

/// Histories 8 KB ahead are prefetched, since the hardware prefetcher stops at the end of a page. Prefetches are best
/// spread among the terms. Where a block takes several registers they would keep the compiler from reordering the
/// arithmetic there, and stand before the block instead.
constexpr int fetch_distance = 1024;
constexpr bool fetches_among_terms = parts == 1;

[[maybe_unused]] BRECCIA_INLINE void fetch_ahead(const Block& block) {
  if (block.by_cell != nullptr) {
    const CellMaterials& cells = *block.by_cell;
    const int lines = cells.shear_term_count * shear_modes + cells.dilatational_term_count;
    for (int line = 0; line < lines; ++line) __builtin_prefetch(cells.history + fetch_distance + line * lanes);
  }
  for (int i = 0; i < block.share_count; ++i) {
    const Share& share = block.shares[i];
    const int lines = share.material->shear_term_count * shear_modes + share.material->bulk_term_count;
    for (int line = 0; line < lines; ++line) __builtin_prefetch(share.history + fetch_distance + line * lanes);
  }
}

/// A term of each cell of a register.
struct TermSteps {
  Pack decay, gain;
};

template <class Term>
BRECCIA_INLINE void advance(Pack& sum, double* history, const Term& term, const Pack& strain) {
  if constexpr (fetches_among_terms) __builtin_prefetch(history + fetch_distance);
  const Pack h = term.decay * load(history) + term.gain * strain;
  store(history, h);
  sum += h;
}

template <int... lane>
struct Lanes {};

template <int count, int... lane>
struct LanesUpTo : LanesUpTo<count - 1, count - 1, lane...> {};

template <int... lane>
struct LanesUpTo<0, lane...> {
  using Type = Lanes<lane...>;
};

/// The first, third ... group of `stride` lanes of each of two rows, those of `a` before those of `b`.
template <int stride, int... lane>
BRECCIA_INLINE Pack even_groups(const Pack& a, const Pack& b, Lanes<lane...> /*all*/) {
  return __builtin_shufflevector(a, b, ((lane & stride) == 0 ? lane : width + lane - stride)...);
}

/// The second, fourth ... group.
template <int stride, int... lane>
BRECCIA_INLINE Pack odd_groups(const Pack& a, const Pack& b, Lanes<lane...> /*all*/) {
  return __builtin_shufflevector(a, b, ((lane & stride) == 0 ? lane + stride : width + lane)...);
}

/// A step of the transposition: exchanges the blocks beside the diagonal in all squares of 2 stride rows.
template <int stride>
BRECCIA_INLINE void exchange_blocks(Pack* rows) {
  using All = typename LanesUpTo<width>::Type;
  for (int row = 0; row < width; ++row) {
    if ((row & stride) != 0) continue;
    const Pack upper = rows[row], lower = rows[row + stride];
    rows[row] = even_groups<stride>(upper, lower, All{});
    rows[row + stride] = odd_groups<stride>(upper, lower, All{});
  }
}

/// Exchanges rows and columns of a square of numbers.
BRECCIA_INLINE void transpose(Pack* rows) {
  exchange_blocks<1>(rows);
  if constexpr (width > 2) exchange_blocks<2>(rows);
  if constexpr (width > 4) exchange_blocks<4>(rows);
}

/// The terms of the cells of a register, one after the other.
class TermsOfCells {
 public:
  BRECCIA_INLINE TermsOfCells(const CellMaterialStep* const* of_lane, const TermStep* CellMaterialStep::*terms) {
    for (int lane = 0; lane < width; ++lane) next_[lane] = of_lane[lane]->*terms;
  }

  /// Term k, where k rises by one from 0. Several terms of a cell fill a register; so they are read together, those of
  /// all cells, and turned into registers of one number for each cell.
  BRECCIA_INLINE TermSteps operator[](int k) {
    const int among = k % terms_in_register;
    if (among == 0) {
      for (int lane = 0; lane < width; ++lane) read_[lane] = load(&next_[lane][k].decay);
      transpose(read_);
    }
    return {read_[2 * among], read_[2 * among + 1]};
  }

 private:
  static constexpr int terms_in_register = width / 2;
  static_assert(sizeof(TermStep) == 2 * sizeof(double));

  const TermStep* next_[width];  // NOLINT(modernize-avoid-c-arrays): nothing of the standard library here
  Pack read_[width];             // NOLINT(modernize-avoid-c-arrays)
};

/// The materials of the cells of a register, each of one material.
struct CellsOfRegister {
  const CellMaterialStep* const* of_lane;
  int shear_term_count;
  int dilatational_term_count;

  [[nodiscard]] BRECCIA_INLINE Pack of_each(double CellMaterialStep::*modulus) const {
    Pack pack{};
    for (int lane = 0; lane < width; ++lane) pack[lane] = of_lane[lane]->*modulus;
    return pack;
  }
};

BRECCIA_INLINE double shear_modulus(const MaterialStep& material) {
  return material.shear;
}

BRECCIA_INLINE const TermStep* shear_terms(const MaterialStep& material) {
  return material.shear_terms;
}

BRECCIA_INLINE Pack shear_modulus(const CellsOfRegister& cells) {
  return cells.of_each(&CellMaterialStep::shear);
}

BRECCIA_INLINE TermsOfCells shear_terms(const CellsOfRegister& cells) {
  return {cells.of_lane, &CellMaterialStep::shear_terms};
}

/// Shear modulus applied to the strain modes: the springs and all Maxwell terms. One material, or those of the cells.
template <class Materials>
BRECCIA_INLINE Modes shear_response(const Materials& materials, const Modes& strain, const Modes& increment,
                                    double* history) {
  const auto g = shear_modulus(materials);
  Modes s = {g * strain.xx, g * strain.yy, g * strain.xy, g * strain.qu, g * strain.qv};
  auto terms = shear_terms(materials);
  for (int k = 0; k < materials.shear_term_count; ++k, history += shear_modes * lanes) {
    const auto& term = terms[k];
    advance(s.xx, history, term, increment.xx);
    advance(s.yy, history + lanes, term, increment.yy);
    advance(s.xy, history + 2 * lanes, term, increment.xy);
    advance(s.qu, history + 3 * lanes, term, increment.qu);
    advance(s.qv, history + 4 * lanes, term, increment.qv);
  }
  return s;
}

/// Bulk modulus applied to the volumetric modes.
template <bool averaged>
BRECCIA_INLINE VolumeModes bulk_response(const MaterialStep& material, const Modes& strain, const Modes& increment,
                                         double* history) {
  constexpr int modes = averaged ? bulk_modes_averaged : bulk_modes_standard;
  const double k_inf = material.bulk;
  VolumeModes p = {k_inf * (strain.xx + strain.yy), k_inf * strain.qu, k_inf * strain.qv};
  for (int k = 0; k < material.bulk_term_count; ++k, history += modes * lanes) {
    const TermStep& term = material.bulk_terms[k];
    advance(p.centre, history, term, increment.xx + increment.yy);
    if constexpr (!averaged) {
      advance(p.qu, history + lanes, term, increment.qu);
      advance(p.qv, history + 2 * lanes, term, increment.qv);
    }
  }
  return p;
}

/// The modulus of equal strains along both axes applied to the strain of the centre.
BRECCIA_INLINE Pack dilatational_response(const CellsOfRegister& cells, const Modes& strain, const Modes& increment,
                                          double* history) {
  Pack p = cells.of_each(&CellMaterialStep::dilatational) * (strain.xx + strain.yy);
  TermsOfCells terms(cells.of_lane, &CellMaterialStep::dilatational_terms);
  for (int k = 0; k < cells.dilatational_term_count; ++k, history += lanes) {
    advance(p, history, terms[k], increment.xx + increment.yy);
  }
  return p;
}

/// Forces of cells of one material each, with averaged volumetric strains (theory, Eq. 7a).
BRECCIA_INLINE Modes forces_of_cells(const CellMaterials& cells, const Modes& strain, const Modes& increment,
                                     int first_lane) {
  const CellsOfRegister of_register = {cells.of_lane + first_lane, cells.shear_term_count,
                                       cells.dilatational_term_count};
  double* history = cells.history + first_lane;
  const Modes s = shear_response(of_register, strain, increment, history);
  history += cells.shear_term_count * shear_modes * lanes;
  const Pack p = dilatational_response(of_register, strain, increment, history);
  return {4.0 * (p + (s.xx - s.yy)), 4.0 * (p - (s.xx - s.yy)), 4.0 * s.xy, 0.5 * s.qu, 0.5 * s.qv};
}

/// Sums over the four points of a cell of one material in closed form (theory, Eq. 7).
template <bool averaged>
BRECCIA_INLINE Modes uniform_forces(const Modes& s, const VolumeModes& p) {
  Modes force{};
  force.xx = 4.0 * (p.centre + (4.0 / 3.0) * s.xx - (2.0 / 3.0) * s.yy);
  force.yy = 4.0 * (p.centre + (4.0 / 3.0) * s.yy - (2.0 / 3.0) * s.xx);
  force.xy = 4.0 * s.xy;
  force.qu = 0.5 * s.qu;
  force.qv = 0.5 * s.qv;
  if constexpr (!averaged) {
    force.qu += (1.0 / 12.0) * s.qu + 0.25 * p.qu;
    force.qv += (1.0 / 12.0) * s.qv + 0.25 * p.qv;
  }
  return force;
}

/// The values of the cells for which `mask` is set (all bits of the lane), zero for the others.
BRECCIA_INLINE Pack masked(const Bits& mask, const Pack& value) {
  return reinterpret_cast<Pack>(reinterpret_cast<Bits>(value) & mask);
}

/// Adds the sums over the points that belong to a share.
template <bool averaged>
BRECCIA_INLINE void add_shared_forces(Modes& force, const std::uint8_t* points_of_cells, const Modes& s,
                                      const VolumeModes& p) {
  Bits points{};
  for (int lane = 0; lane < width; ++lane) points[lane] = points_of_cells[lane];
  for (int point = 0; point < 4; ++point) {
    Bits bit{};
    for (int lane = 0; lane < width; ++lane) bit[lane] = 1LL << point;
    const Bits mask = (points & bit) != Bits{};
    const double x = (point & 1) != 0 ? 0.25 : -0.25;
    const double y = (point & 2) != 0 ? 0.25 : -0.25;
    // Averaged points see the mean of the volumetric strain, half of it in each direction.
    const Pack gradient_xx = averaged ? 0.5 * (y * s.qu - x * s.qv) : y * s.qu;
    const Pack gradient_yy = averaged ? -gradient_xx : x * s.qv;
    const Pack exx = s.xx + gradient_xx;
    const Pack eyy = s.yy + gradient_yy;
    const Pack pressure = averaged ? p.centre : p.centre + y * p.qu + x * p.qv;
    const Pack dxx = masked(mask, (4.0 / 3.0) * exx - (2.0 / 3.0) * eyy);
    const Pack dyy = masked(mask, (4.0 / 3.0) * eyy - (2.0 / 3.0) * exx);
    const Pack sxy = masked(mask, s.xy + x * s.qu + y * s.qv);
    const Pack sp = masked(mask, pressure);
    force.xx += sp + dxx;
    force.yy += sp + dyy;
    force.xy += sxy;
    force.qu += y * (averaged ? 0.5 * (dxx - dyy) : sp + dxx) + x * sxy;
    force.qv += x * (averaged ? 0.5 * (dyy - dxx) : sp + dyy) + y * sxy;
  }
}

/// Forces on the nodes: minus a quarter (the volume of a point) of the transpose of Eq. 6.
BRECCIA_INLINE void store_forces(const Modes& f, const CellRow& row, int cell) {
  const Pack xx = 0.125 * f.xx, yy = 0.125 * f.yy, xy = 0.125 * f.xy;
  const Pack qu = 0.25 * f.qu, qv = 0.25 * f.qv;
  store(row.below.left_x + cell, (xx + xy) - qu);
  store(row.below.right_x + cell + 1, (xy - xx) + qu);
  store(row.above.left_x + cell, (xx - xy) + qu);
  store(row.above.right_x + cell + 1, -(xx + xy) - qu);
  store(row.below.left_y + cell, (yy + xy) - qv);
  store(row.below.right_y + cell + 1, (yy - xy) + qv);
  store(row.above.left_y + cell, (xy - yy) + qv);
  store(row.above.right_y + cell + 1, -(yy + xy) - qv);
}

/// Forces of the cells of one register, times the cell side.
template <bool averaged>
BRECCIA_INLINE Modes forces(const CellRow& row, const Block& block, int cell, int first_lane) {
  const Modes strain = strain_modes(row.displacement_below, row.displacement_above, cell);
  Modes increment{};
  if (block.relaxes) increment = strain_modes(row.increment_below, row.increment_above, cell);
  if (averaged && block.by_cell != nullptr) return forces_of_cells(*block.by_cell, strain, increment, first_lane);
  Modes force{};
  for (int i = 0; i < block.share_count; ++i) {
    const Share& share = block.shares[i];
    const MaterialStep& material = *share.material;
    double* shear_history = share.history + first_lane;
    double* bulk_history = shear_history + material.shear_term_count * shear_modes * lanes;
    const Modes s = shear_response(material, strain, increment, shear_history);
    const VolumeModes p = bulk_response<averaged>(material, strain, increment, bulk_history);
    if (block.uniform) {
      force = uniform_forces<averaged>(s, p);
    } else {
      add_shared_forces<averaged>(force, share.points + first_lane, s, p);
    }
  }
  return force;
}

/// Sums over the lanes of a block, in an order that does not depend on the width of a register.
struct LaneSums {
  Pack values[parts] = {};  // NOLINT(modernize-avoid-c-arrays): nothing of the standard library here

  BRECCIA_INLINE void add(int part, const Pack& value) { values[part] += value; }
  [[nodiscard]] BRECCIA_INLINE double lane(int i) const { return values[i / width][i % width]; }
  [[nodiscard]] BRECCIA_INLINE double total() const {
    return ((lane(0) + lane(1)) + (lane(2) + lane(3))) + ((lane(4) + lane(5)) + (lane(6) + lane(7)));
  }
};

template <bool averaged>
void cell_row(const CellRow& row) {
  LaneSums stress_xx, stress_yy, stress_xy;
  for (int b = 0; b < row.block_count; ++b) {
    if constexpr (!fetches_among_terms) {
      if (row.blocks[b].relaxes) fetch_ahead(row.blocks[b]);
    }
    for (int part = 0; part < parts; ++part) {
      const int cell = b * lanes + part * width;
      const Modes force = forces<averaged>(row, row.blocks[b], cell, part * width);
      stress_xx.add(part, force.xx);
      stress_yy.add(part, force.yy);
      stress_xy.add(part, force.xy);
      store_forces(force, row, cell);
    }
  }
  row.stress[0] = stress_xx.total();
  row.stress[1] = stress_yy.total();
  row.stress[2] = stress_xy.total();
}

BRECCIA_INLINE void move_nodes(const NodeRow& row, int node, double* displacement, double* increment,
                               const double* left_below, const double* right_below, const double* left_above,
                               const double* right_above) {
  const Pack force =
      (load(left_below + node) + load(right_below + node)) + (load(left_above + node) + load(right_above + node));
  const Pack moved = load(increment + node) + load(row.step_over_mass + node) * force;
  store(increment + node, moved);
  store(displacement + node, load(displacement + node) + moved);
}

void node_row(const NodeRow& row) {
  const RowForces& below = row.from_cells_below;
  const RowForces& above = row.from_cells_above;
  for (int node = 0; node < row.count; node += width) {
    move_nodes(row, node, row.displacement_x, row.increment_x, below.left_x, below.right_x, above.left_x,
               above.right_x);
    move_nodes(row, node, row.displacement_y, row.increment_y, below.left_y, below.right_y, above.left_y,
               above.right_y);
  }
}

}  // namespace

extern const KernelTable BRECCIA_KERNEL_TABLE;
const KernelTable BRECCIA_KERNEL_TABLE = {cell_row<true>, cell_row<false>, node_row};

}  // namespace breccia::dynamics
