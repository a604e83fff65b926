#pragma once

// Registers of several cells, for the kernels, which are compiled once for every instruction set with
// BRECCIA_REGISTER_LANES naming the doubles that a register holds. Everything here and in the kernels has internal
// linkage and nothing of the standard library is used, so that no code for a newer processor leaks into others.

#include "dynamics/cell_row_kernel.hpp"
#include "dynamics/point_map.hpp"

namespace breccia::dynamics {
namespace {  // NOLINT(google-build-namespaces): see above

// NOLINTBEGIN(misc-definitions-in-headers): see above
constexpr int width = BRECCIA_REGISTER_LANES;  ///< cells in a register; a block takes lanes / width of them
constexpr int parts = lanes / width;
// NOLINTEND(misc-definitions-in-headers)

typedef double Pack __attribute__((vector_size(width * sizeof(double))));        // NOLINT(modernize-use-using)
typedef long long Bits __attribute__((vector_size(width * sizeof(long long))));  // NOLINT(modernize-use-using)

BRECCIA_INLINE Pack load(const double* from) {
  Pack pack;
  __builtin_memcpy(&pack, from, sizeof(pack));
  return pack;
}

BRECCIA_INLINE void store(double* to, const Pack& pack) {
  __builtin_memcpy(to, &pack, sizeof(pack));
}

/// Histories 8 KB ahead are prefetched, since the hardware prefetcher stops at the end of a page. Those of cubes go
/// into the second level of the cache, because the first can wait for too few lines at a time to use the bandwidth;
/// those of squares, which are short and often in the cache, into the first. Prefetches are best spread among the
/// terms. Where a block takes several registers they would keep the compiler from reordering the arithmetic there, and
/// stand before the block instead.
constexpr int fetch_distance = 1024;              // NOLINT(misc-definitions-in-headers): see above
constexpr bool fetches_among_terms = parts == 1;  // NOLINT(misc-definitions-in-headers)

template <int dim>
BRECCIA_INLINE void fetch_ahead(const double* history) {
  constexpr int for_reading = 0, into_second_level = 2, into_first_level = 3;
  __builtin_prefetch(history + fetch_distance, for_reading, dim == 3 ? into_second_level : into_first_level);
}

template <int dim>
[[maybe_unused]] BRECCIA_INLINE void fetch_ahead(const Block& block) {
  if (block.by_cell != nullptr) {
    const CellMaterials& cells = *block.by_cell;
    const int lines = cells.shear_term_count * shear_modes<dim> + cells.dilatational_term_count;
    for (int line = 0; line < lines; ++line) fetch_ahead<dim>(cells.history + line * lanes);
  }
  for (int i = 0; i < block.share_count; ++i) {
    const Share& share = block.shares[i];
    const int lines = share.material->shear_term_count * shear_modes<dim> + share.material->bulk_term_count;
    for (int line = 0; line < lines; ++line) fetch_ahead<dim>(share.history + line * lanes);
  }
}

/// A term of each cell of a register.
struct TermSteps {
  Pack decay, gain;
};

template <int dim, class Term>
BRECCIA_INLINE void advance(Pack& sum, double* history, const Term& term, const Pack& strain) {
  if constexpr (fetches_among_terms) fetch_ahead<dim>(history);
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

/// The second, fourth ... group of `stride` lanes of each of two rows.
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
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): read_ is filled with the first term
  BRECCIA_INLINE TermsOfCells(const CellMaterialStep* const* of_lane, const TermStep* CellMaterialStep::*terms) {
    for (int lane = 0; lane < width; ++lane) next_[lane] = of_lane[lane]->*terms;
  }

  /// Term k, where k rises by one from 0. Several terms of a cell fill a register; so the terms of all cells are read
  /// together and transposed into registers with one number for each cell.
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

/// The values of the cells for which `mask` is set (all bits of the lane), and zero for the other cells.
BRECCIA_INLINE Pack masked(const Bits& mask, const Pack& value) {
  return reinterpret_cast<Pack>(reinterpret_cast<Bits>(value) & mask);
}

/// Strain modes of the cells of a register, times the cell side; or their products with a modulus, or the forces on
/// them.
template <int dim>
struct Modes {
  Pack of[shear_modes<dim>];  // NOLINT(modernize-avoid-c-arrays): nothing of the standard library here
};

/// Volumetric strain modes of the cells of a register, times the cell side, or the pressures that belong to them.
template <int dim>
struct VolumeModes {
  Pack of[bulk_modes_standard<dim>];  // NOLINT(modernize-avoid-c-arrays): nothing of the standard library here
};

/// Forces along one axis on the nodes at the left and at the right of the cells of a register, in one row of nodes.
struct NodeForces {
  Pack left, right;
};

/// Sums over the lanes of a block, in an order that does not depend on the width of a register.
struct LaneSums {
  Pack values[parts] = {};  // NOLINT(modernize-avoid-c-arrays): nothing of the standard library here

  BRECCIA_INLINE void add(int part, const Pack& value) { values[part] += value; }
  [[nodiscard]] BRECCIA_INLINE double lane(int i) const { return values[i / width][i % width]; }
  [[nodiscard]] BRECCIA_INLINE double total() const {
    return ((lane(0) + lane(1)) + (lane(2) + lane(3))) + ((lane(4) + lane(5)) + (lane(6) + lane(7)));
  }
};

}  // namespace
}  // namespace breccia::dynamics
