#include "microstructure/tessellation/tessellation_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <set>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/microstructure/ball.hpp"

#include "microstructure/vector_algebra.hpp"

namespace breccia {

namespace {

template <int dim>
GrainGeometry<dim> grain_geometry(const Tessellation<dim>& tessellation, std::size_t site, double film) {
  const auto& cell = tessellation.cell(site);
  const auto grain = tessellation.grain(site, film);
  const auto of_cell = moments(cell);
  const auto faces = face_measures(grain);
  std::vector<std::size_t> behind;
  for (const auto& face : cell.half_spaces()) {
    if (const auto neighbour = Tessellation<dim>::neighbour(face)) behind.push_back(*neighbour);
  }
  GrainGeometry<dim> result{};
  result.centroid = tessellation.sites().sites[site].position + of_cell.centroid;
  result.cell_volume = of_cell.volume;
  result.grain_volume = volume(grain);
  result.grain_surface = std::accumulate(faces.begin(), faces.end(), 0.0);
  result.diameter = std::pow(result.grain_volume / ball_volume<dim>(1.0), 1.0 / dim);
  result.aspect_ratio = aspect_ratio(of_cell);
  result.faces = behind.size();
  std::set<std::size_t> others(behind.begin(), behind.end());
  others.erase(site);
  result.neighbours = others.size();
  return result;
}

template <class Member, class Geometry>
Spread spread(const std::vector<Geometry>& grains, Member member) {
  const auto count = static_cast<double>(grains.size());
  const auto value = [&](const Geometry& grain) { return std::invoke(member, grain); };
  Spread result;
  result.smallest = value(*std::ranges::min_element(grains, {}, value));
  result.largest = value(*std::ranges::max_element(grains, {}, value));
  for (const auto& grain : grains) result.mean += value(grain) / count;
  double square = 0.0;
  for (const auto& grain : grains) square += std::pow(value(grain) - result.mean, 2) / count;
  result.deviation = std::sqrt(square);
  return result;
}

}  // namespace

template <int dim>
std::vector<GrainGeometry<dim>> grain_geometries(const Tessellation<dim>& tessellation, double film) {
  std::vector<GrainGeometry<dim>> grains;
  grains.reserve(tessellation.size());
  for (std::size_t site = 0; site < tessellation.size(); ++site) {
    grains.push_back(grain_geometry(tessellation, site, film));
  }
  return grains;
}

template <int dim>
TessellationStatistics statistics(const Tessellation<dim>& tessellation, double film) {
  using Geometry = GrainGeometry<dim>;
  const auto grains = grain_geometries(tessellation, film);
  const double box = times_power<dim>(1.0, tessellation.side());
  TessellationStatistics result;
  result.grains = grains.size();
  result.cell_volume = spread(grains, &Geometry::cell_volume);
  result.diameter = spread(grains, &Geometry::diameter);
  result.aspect_ratio = spread(grains, &Geometry::aspect_ratio);
  for (std::size_t site = 0; site < grains.size(); ++site) {
    const auto& cell = tessellation.cell(site);
    const auto faces = face_measures(cell);
    if (grains[site].grain_volume == 0.0) ++result.vanished;
    result.fraction += grains[site].grain_volume / box;
    for (std::size_t face = 0; face < faces.size(); ++face) {
      if (tessellation.recedes(cell.half_spaces()[face])) result.film_surface += 0.5 * faces[face] / box;
    }
    result.mean_faces += static_cast<double>(grains[site].faces) / static_cast<double>(grains.size());
  }
  return result;
}

template <int dim>
double largest_volume_error(const Tessellation<dim>& tessellation, std::span<const double> volumes) {
  if (volumes.size() != tessellation.size()) {
    throw InputError(fmt::format("tessellation: {} cells need as many volumes to compare with, got {}",
                                 tessellation.size(), volumes.size()));
  }
  const double scale =
      times_power<dim>(1.0, tessellation.side()) / std::accumulate(volumes.begin(), volumes.end(), 0.0);
  double largest = 0.0;
  for (std::size_t site = 0; site < volumes.size(); ++site) {
    largest = std::max(largest, std::abs(volume(tessellation.cell(site)) / (scale * volumes[site]) - 1.0));
  }
  return largest;
}

template std::vector<GrainGeometry<2>> grain_geometries(const Tessellation<2>&, double);
template std::vector<GrainGeometry<3>> grain_geometries(const Tessellation<3>&, double);
template TessellationStatistics statistics(const Tessellation<2>&, double);
template TessellationStatistics statistics(const Tessellation<3>&, double);
template double largest_volume_error(const Tessellation<2>&, std::span<const double>);
template double largest_volume_error(const Tessellation<3>&, std::span<const double>);

}  // namespace breccia
