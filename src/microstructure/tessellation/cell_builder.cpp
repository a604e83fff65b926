#include "microstructure/tessellation/cell_builder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "microstructure/vector_algebra.hpp"

namespace breccia {

namespace {

/// The weight of a grain of no size, if the mean square of the grains' radii is that of equal discs that fill the box.
template <int dim>
double base_weight(const std::vector<Site<dim>>& sites, double spacing) {
  double mean = 0.0;
  for (const auto& site : sites) mean += site.weight / static_cast<double>(sites.size());
  return mean - spacing * spacing / std::numbers::pi;
}

/// Radii of balls around the sites [m], by which LevelGrid finds the sites. No radius is less than sqrt(weight - base).
template <int dim>
std::vector<double> radii_of_weights(const std::vector<Site<dim>>& sites, double base, double smallest) {
  std::vector<double> radii;
  radii.reserve(sites.size());
  for (const auto& site : sites) radii.push_back(std::sqrt(std::max(smallest * smallest, site.weight - base)));
  return radii;
}

}  // namespace

template <int dim>
CellBuilder<dim>::CellBuilder(const LaguerreSites<dim>& sites)
    : sites_(sites),
      images_(sites.side),
      spacing_(sites.side * std::pow(static_cast<double>(sites.sites.size()), -1.0 / dim)),
      base_weight_(base_weight(sites.sites, spacing_)),
      radii_(radii_of_weights(sites.sites, base_weight_, 0.1 * spacing_)),
      grid_(sites.side, sites.walls, radii_) {
  for (std::uint32_t site = 0; site < radii_.size(); ++site) grid_.insert(site, sites.sites[site].position);
}

/// The first cell of a site: the box, or the set of points that are nearer to the site than to its own images.
template <int dim>
ConvexCell<dim> CellBuilder<dim>::largest_cell(std::uint32_t site) const {
  Vector<dim> lower, upper;
  typename ConvexCell<dim>::BoxSides behind;
  Image step = 1;  // difference of the numbers of an image and the next one above along the axis
  for (std::size_t axis = 0; axis < dim; ++axis) {
    if (sites_.walls == Walls::hard) {
      lower[axis] = -sites_.sites[site].position[axis];
      upper[axis] = sites_.side - sites_.sites[site].position[axis];
      behind[axis].fill(Behind<dim>::wall);
    } else {
      lower[axis] = -0.5 * sites_.side;
      upper[axis] = 0.5 * sites_.side;
      behind[axis] = {Behind<dim>::number(site, PeriodicImages<dim>::in_place - step),
                      Behind<dim>::number(site, PeriodicImages<dim>::in_place + step)};
    }
    step *= 3;
  }
  return {lower, upper, behind};
}

/// The half-space of the points that are nearer to the site than to another site or an image of it. Of two sites at the
/// same point with equal weights the first owns all points.
template <int dim>
HalfSpace<dim> CellBuilder<dim>::half_space(std::uint32_t site, std::uint32_t behind) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::uint32_t other = Behind<dim>::site(behind);
  const auto& [position, weight] = sites_.sites[site];
  const auto& [other_position, other_weight] = sites_.sites[other];
  const auto apart = other_position + images_.shift(Behind<dim>::image(behind)) - position;
  const double distance = norm(apart);
  if (distance == 0.0) {
    const bool has_everything = weight > other_weight || (weight == other_weight && site < other);
    return {{1.0}, has_everything ? infinity : -infinity, behind};
  }
  return {(1.0 / distance) * apart, 0.5 * (distance + (weight - other_weight) / distance), behind};
}

/// The reach within which sites may cut the cell. With corners up to R away, a site at distance D cuts nothing if its
/// plane is beyond them, (D^2 + w - w') / (2 D) >= R, which holds for D >= R + sqrt(max(0, R^2 - w + w')). With the
/// base w0 of the weights and w' <= w0 + r'^2 it holds for D >= R + sqrt(max(0, R^2 - w + w0)) + r'. Only sites with D
/// less than reach + r' remain, and these are among the balls that LevelGrid finds.
template <int dim>
double CellBuilder<dim>::search_reach(const ConvexCell<dim>& cell, std::uint32_t site) const {
  const double reach = cell.reach();
  return reach + std::sqrt(std::max(0.0, reach * reach - sites_.sites[site].weight + base_weight_));
}

/// Cuts the cell by the sites that LevelGrid finds within this reach. The nearest planes come first, so that most
/// further planes do not touch the remaining cell.
template <int dim>
void CellBuilder<dim>::cut_by_sites_within(double reach, ConvexCell<dim>& cell, std::uint32_t site) const {
  const auto& [position, weight] = sites_.sites[site];
  const double farthest = cell.reach();
  // A plane can only cut if its offset (D^2 + w - w') / (2 D) is less than the distance of the farthest corner; no root
  // is taken for the many sites whose plane cannot.
  const auto may_cut = [&, point = position, own = weight](std::uint32_t other, Image image) {
    const auto& [other_position, other_weight] = sites_.sites[other];
    const auto apart = other_position + images_.shift(image) - point;
    const double square = dot(apart, apart);
    const double numerator = square + own - other_weight;
    return numerator < 0.0 || numerator * numerator < 4.0 * farthest * farthest * square || square == 0.0;
  };
  std::vector<HalfSpace<dim>> half_spaces;
  grid_.visit_near(position, reach, [&](std::uint32_t other, Image image) {
    // The largest cell is bounded by the images of its own site already.
    if (other == site || !may_cut(other, image)) return;
    half_spaces.push_back(half_space(site, Behind<dim>::number(other, image)));
  });
  std::ranges::sort(half_spaces, {},
                    [](const auto& candidate) { return std::pair(candidate.offset, candidate.behind); });
  double present_reach = farthest;
  for (const auto& candidate : half_spaces) {
    if (candidate.offset >= present_reach) break;
    if (cell.cut(candidate)) present_reach = cell.reach();
  }
}

// The images next to the box are enough. Let an image of another site be at D with D_x >= L along some axis. The cell
// is within the largest one, |x| <= L/2, and there the image one side nearer is as near as that at D or nearer: |x -
// D|^2 - |x - D + L e_x|^2 = L (2 (D_x - x) - L) >= 0. So only images with all |D_x| < L can have a face, and from a
// site in the box these are in place or next to it.
template <int dim>
ConvexCell<dim> CellBuilder<dim>::cell(std::uint32_t site, std::span<const std::uint32_t> likely) const {
  ConvexCell<dim> result = largest_cell(site);
  for (const std::uint32_t behind : likely) result.cut(half_space(site, behind));
  double reach = likely.empty() ? 0.5 * spacing_ + radii_[site] : std::numeric_limits<double>::infinity();
  for (bool is_whole = false; !is_whole && !result.is_empty(); reach *= 2.0) {
    reach = std::min(reach, search_reach(result, site));
    cut_by_sites_within(reach, result, site);
    is_whole = reach >= search_reach(result, site);
  }
  result.trim();
  return result;
}

template <int dim>
std::vector<ConvexCell<dim>> CellBuilder<dim>::cells() const {
  std::vector<ConvexCell<dim>> result;
  result.reserve(sites_.sites.size());
  for (std::uint32_t site = 0; site < sites_.sites.size(); ++site) result.push_back(cell(site));
  return result;
}

template class CellBuilder<2>;
template class CellBuilder<3>;

}  // namespace breccia
