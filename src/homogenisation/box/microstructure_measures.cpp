#include "homogenisation/box/microstructure_measures.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "breccia/microstructure/statistics.hpp"

#include "homogenisation/box/debonded_films.hpp"
#include "homogenisation/box/effective_number.hpp"
#include "homogenisation/box/shaped_measures.hpp"
#include "microstructure/image/image_statistics.hpp"
#include "microstructure/tessellation/tessellation_statistics.hpp"
#include "study/coatings.hpp"

namespace breccia {

namespace {

/// A quantile of these areas [m^2] (in three dimensions volumes [m^3]), weighted by area (volume), as the diameter [m]
/// of a disc (ball) of that size: smaller ones make up this share of the sum.
template <int dim>
double diameter_below(std::span<const double> rising_areas, double share) {
  const double whole = std::accumulate(rising_areas.begin(), rising_areas.end(), 0.0);
  double below = 0.0;
  const auto found = std::ranges::find_if(rising_areas, [&](double area) { return (below += area) >= share * whole; });
  if constexpr (dim == 3) return std::cbrt(6.0 * *found / std::numbers::pi);
  return 2.0 * std::sqrt(*found / std::numbers::pi);
}

template <int dim>
std::vector<double> areas_of(const std::vector<GrainGeometry<dim>>& grains, double GrainGeometry<dim>::*area) {
  std::vector<double> areas;
  areas.reserve(grains.size());
  for (const auto& grain : grains) areas.push_back(grain.*area);
  return areas;
}

template <int dim>
SizesByArea sizes_by_area(const std::vector<GrainGeometry<dim>>& grains, double GrainGeometry<dim>::*area) {
  if (grains.empty()) return {};
  auto areas = areas_of(grains, area);
  std::ranges::sort(areas);
  return {diameter_below<dim>(areas, 0.1), diameter_below<dim>(areas, 0.5)};
}

/// Thickness of the thinnest film between the cells of a tessellation [m]; `film` if there are no two cells.
template <int dim>
double thinnest_film(const Tessellation<dim>& tessellation, double film) {
  double thinnest = std::numeric_limits<double>::infinity();
  for (std::size_t site = 0; site < tessellation.size(); ++site) {
    for (const auto& face : tessellation.cell(site).half_spaces()) {
      if (!Tessellation<dim>::neighbour(face)) continue;
      thinnest = std::min(thinnest, 2.0 * tessellation.half_film(site, face, film));
    }
  }
  return std::isfinite(thinnest) ? thinnest : film;
}

/// Length of the films shorter than five times their thickness over that of all films. The faces of the cells are in
/// the middle of the films.
double share_of_short_films(const Tessellation<2>& tessellation, double film) {
  double all = 0.0, in_short_films = 0.0;
  for (std::size_t site = 0; site < tessellation.size(); ++site) {
    const auto& cell = tessellation.cell(site);
    const auto lengths = face_measures(cell);
    for (std::size_t face = 0; face < lengths.size(); ++face) {
      if (!Tessellation<2>::neighbour(cell.half_spaces()[face])) continue;
      all += lengths[face];
      const double thickness = 2.0 * tessellation.half_film(site, cell.half_spaces()[face], film);
      if (lengths[face] < 5.0 * thickness) in_short_films += lengths[face];
    }
  }
  return all > 0.0 ? in_short_films / all : 0.0;
}

template <int dim>
void measure_content(const Stage& stage, Grains<dim>& filling, StageMicrostructure& result) {
  const Tessellation<dim> tessellation(filling.sites);
  auto& own = filling.statistics;
  const double film = own.film;
  own.cell_count = tessellation.size();
  auto grains = grain_geometries(tessellation, film);
  own.cells = sizes_by_area(grains, &GrainGeometry<dim>::cell_volume);
  std::erase_if(grains, [](const GrainGeometry<dim>& grain) { return !(grain.grain_volume > 0.0); });
  own.count = grains.size();
  own.sizes = sizes_by_area(grains, &GrainGeometry<dim>::grain_volume);
  result.effective_particles = effective_number(areas_of(grains, &GrainGeometry<dim>::grain_volume));
  double outlines = 0.0;
  for (const auto& grain : grains) outlines += grain.grain_surface;
  double box = 1.0;
  for (int axis = 0; axis < dim; ++axis) box *= tessellation.side();
  result.fraction = grain_fraction(tessellation, film);
  result.interface_per_area = outlines / box;
  result.gap = thinnest_film(tessellation, film);
  const auto debonded = debonded_films(stage, tessellation);
  own.debonded_films = debonded.faces.size();
  own.debonded = debonded.share;
  if constexpr (dim == 2) own.short_films = share_of_short_films(tessellation, film);
  const auto& sites = filling.sites;
  const bool has_films_along_walls = sites.walls == Walls::hard && sites.wall_film == WallFilm::half;
  result.wall_gap = has_films_along_walls ? 0.5 * film : std::numeric_limits<double>::infinity();
  const auto deviation = result.fillers.empty() ? std::nullopt : result.fillers.front().size_deviation;
  result.fillers = {{.particles = own.count, .fraction = result.fraction, .size_deviation = deviation}};
  if (grains.empty()) return;
  const auto [smallest, largest] = std::ranges::minmax(grains, {}, &GrainGeometry<dim>::diameter);
  result.fillers.front().smallest_diameter = smallest.diameter;
  result.fillers.front().largest_diameter = largest.diameter;
}

template <int dim>
void measure_content(const Stage& stage, const SharedImage<dim>& image, StageMicrostructure& result) {
  const auto fractions = label_fractions(*image, stage.fillers.size() + 1);
  result.fillers.clear();
  for (std::size_t filler = 0; filler < stage.fillers.size(); ++filler) {
    result.fillers.push_back({.fraction = fractions[filler + 1]});
    result.fraction += fractions[filler + 1];
  }
  result.interface_per_area = specific_interface(*image);
  // Pixels do not distinguish particles, so that gaps between these are not known.
  result.gap = std::numeric_limits<double>::infinity();
  result.wall_gap = std::numeric_limits<double>::infinity();
}

template <int dim>
void measure_content(const Stage& stage, const Microstructure<dim>& balls, StageMicrostructure& result) {
  const auto coated = with_coatings(stage, balls);
  result.fraction = volume_fraction(balls);
  result.interface_per_area = specific_surface(balls);
  result.gap = smallest_gap(coated);
  result.wall_gap = smallest_wall_gap(coated);
  std::vector<double> volumes;
  volumes.reserve(balls.particles.size());
  for (const auto& particle : balls.particles) volumes.push_back(std::pow(particle.diameter, dim));
  result.effective_particles = effective_number(volumes);
  auto fillers = filler_statistics(stage, balls);
  for (std::size_t number = 0; number < std::min(fillers.size(), result.fillers.size()); ++number) {
    fillers[number].size_deviation = result.fillers[number].size_deviation;
  }
  result.fillers = std::move(fillers);
}

}  // namespace

void measure(const Stage& stage, StageMicrostructure& result) {
  visit_nested([&](auto& content) { measure_content(stage, content, result); }, result.box);
}

}  // namespace breccia
