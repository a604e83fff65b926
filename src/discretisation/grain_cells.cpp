#include "discretisation/grain_cells.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "discretisation/mixture_numbers.hpp"

namespace breccia {
namespace {

/// Adds the shares of the cells of a range of a grid that grains cover.
template <int dim>
class GrainShares {
 public:
  GrainShares(const Grid<dim>& grid, const IndexRange<dim>& range, Walls walls)
      : grid_(grid), range_(range), walls_(walls), shares_(Grid<dim>{.cells = range.size()}.cell_count(), 0.0) {
    for (std::size_t axis = 0; axis < dim; ++axis) {
      lower_[axis] = -0.5 * grid.cell_side;
      upper_[axis] = 0.5 * grid.cell_side;
    }
  }

  [[nodiscard]] double of(const Index<dim>& cell) const noexcept { return shares_[range_.place_of(cell)]; }

  /// Adds a grain given relative to a position in the box [m]. In a periodic box it may reach beyond the sides.
  void add(const ConvexCell<dim>& grain, const Vector<dim>& position) {
    Index<dim> begin{}, end{};
    for (std::size_t axis = 0; axis < begin.size(); ++axis) {
      double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
      for (const auto& corner : grain.corners()) {
        lowest = std::min(lowest, position[axis] + corner.position[axis]);
        highest = std::max(highest, position[axis] + corner.position[axis]);
      }
      begin[axis] = static_cast<int>(std::floor(lowest / grid_.cell_side));
      end[axis] = static_cast<int>(std::floor(highest / grid_.cell_side)) + 1;
      if (walls_ == Walls::periodic) continue;
      begin[axis] = std::max(begin[axis], 0);
      end[axis] = std::min(end[axis], grid_.cells[axis]);
    }
    for_each_index(begin, end, [&](const Index<dim>& cell) {
      const auto inside = in_box(cell);
      if (!range_.contains(inside)) return;
      const double share = share_of(grain.half_spaces(), cell, position);
      if (share > 0.0) shares_[range_.place_of(inside)] += share;
    });
  }

 private:
  [[nodiscard]] Index<dim> in_box(Index<dim> cell) const noexcept {
    for (std::size_t axis = 0; axis < cell.size(); ++axis) {
      const int count = grid_.cells[axis];
      cell[axis] = (cell[axis] % count + count) % count;
    }
    return cell;
  }

  /// The share of a cell that is in all of the half-spaces, which are given relative to the position.
  [[nodiscard]] double share_of(std::span<const HalfSpace<dim>> half_spaces, const Index<dim>& cell,
                                const Vector<dim>& position) {
    Vector<dim> centre{};
    for (std::size_t axis = 0; axis < centre.size(); ++axis) {
      centre[axis] = (cell[axis] + 0.5) * grid_.cell_side - position[axis];
    }
    crossing_.clear();
    for (const auto& half_space : half_spaces) {
      double reach = 0.0;  // half the extent of the cell along the normal, from its centre
      for (const double n : half_space.normal) reach += 0.5 * grid_.cell_side * std::abs(n);
      const double height = half_space.height(centre);
      if (height >= reach) return 0.0;
      if (height > -reach) crossing_.push_back({half_space.normal, -height, half_space.behind});
    }
    if (crossing_.empty()) return 1.0;
    ConvexCell<dim> rest(lower_, upper_, {});
    for (const auto& half_space : crossing_) rest.cut(half_space);
    return volume(rest) / times_power<dim>(1.0, grid_.cell_side);
  }

  Grid<dim> grid_;
  IndexRange<dim> range_;
  Walls walls_;
  std::vector<double> shares_;
  std::vector<HalfSpace<dim>> crossing_;  // the half-spaces whose planes cross a cell, relative to its centre
  Vector<dim> lower_{}, upper_{};         // corners of a cell, relative to its centre
};

}  // namespace

template <int dim>
Discretisation<dim> discretise_mixed(const Tessellation<dim>& tessellation, double film, int cells, PhaseIndex matrix,
                                     PhaseIndex grains, std::size_t phases, const CellLayers& layers) {
  if (std::max(matrix, grains) >= phases) {
    throw InputError(fmt::format("discretisation: a phase has the number {}, counted from 0, but there are only {}",
                                 std::max(matrix, grains), phases));
  }
  if (!(film >= 0.0) || !std::isfinite(film)) {
    throw InputError(
        fmt::format("discretisation: the thickness of a film must be finite and not negative, got {} m", film));
  }
  Grid<dim> grid{.cell_side = tessellation.side() / cells};
  grid.cells.fill(cells);
  Discretisation<dim> discretisation(grid, matrix, layers);
  const auto& range = discretisation.range();
  GrainShares<dim> covered(grid, range, tessellation.walls());
  for (std::size_t site = 0; site < tessellation.size(); ++site) {
    auto grain = tessellation.grain(site, film);
    grain.trim();
    if (!grain.is_empty()) covered.add(grain, tessellation.sites().sites[site].position);
  }
  MixtureNumbers<dim> numbers(discretisation, phases);
  // Number of units in a cell; a unit is far smaller than a step of the fractions of mixtures.
  constexpr std::int64_t whole = std::int64_t{1} << 40;
  std::vector<std::int64_t> units(phases, 0);
  for_each_index(range.begin, range.end, [&](const Index<dim>& cell) {
    const double share = std::min(1.0, covered.of(cell));
    units[grains] = std::llround(share * static_cast<double>(whole));
    units[matrix] = whole - units[grains];
    numbers.fill(cell, rounded_content(units));
  });
  return discretisation;
}

template Discretisation<2> discretise_mixed(const Tessellation<2>&, double, int, PhaseIndex, PhaseIndex, std::size_t,
                                            const CellLayers&);
template Discretisation<3> discretise_mixed(const Tessellation<3>&, double, int, PhaseIndex, PhaseIndex, std::size_t,
                                            const CellLayers&);

}  // namespace breccia
