#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "breccia/microstructure/convex_cell.hpp"
#include "breccia/microstructure/laguerre_sites.hpp"

#include "microstructure/level_grid.hpp"
#include "microstructure/periodic_images.hpp"

namespace breccia {

/// The neighbour behind a face of a cell, as one number: an image of a site, or a wall.
template <int dim>
struct Behind {
  static constexpr std::uint32_t wall = std::numeric_limits<std::uint32_t>::max();
  using Images = PeriodicImages<dim>;

  [[nodiscard]] static std::uint32_t number(std::uint32_t site, typename Images::Image image) noexcept {
    return site * Images::count + image;
  }
  [[nodiscard]] static std::uint32_t site(std::uint32_t number) noexcept { return number / Images::count; }
  [[nodiscard]] static typename Images::Image image(std::uint32_t number) noexcept { return number % Images::count; }
};

/// Cuts the cells of a Laguerre tessellation out of the box. The sites must outlive it; they are in the box, and their
/// weights are finite.
template <int dim>
class CellBuilder {
 public:
  explicit CellBuilder(const LaguerreSites<dim>& sites);

  /// The cell of a site, relative to its position. `likely` are numbers (Behind) of sites that may be its neighbours:
  /// the more neighbours are among them, the sooner the cell is found. Other sites do not change the result.
  [[nodiscard]] ConvexCell<dim> cell(std::uint32_t site, std::span<const std::uint32_t> likely = {}) const;
  /// All cells, by site.
  [[nodiscard]] std::vector<ConvexCell<dim>> cells() const;

 private:
  using Image = typename PeriodicImages<dim>::Image;

  [[nodiscard]] ConvexCell<dim> largest_cell(std::uint32_t site) const;
  [[nodiscard]] HalfSpace<dim> half_space(std::uint32_t site, std::uint32_t behind) const;
  [[nodiscard]] double search_reach(const ConvexCell<dim>& cell, std::uint32_t site) const;
  void cut_by_sites_within(double reach, ConvexCell<dim>& cell, std::uint32_t site) const;

  const LaguerreSites<dim>& sites_;
  PeriodicImages<dim> images_;
  double spacing_;  // spacing of equal grains of this number [m]
  double base_weight_;
  std::vector<double> radii_;
  LevelGrid<dim> grid_;
};

}  // namespace breccia
