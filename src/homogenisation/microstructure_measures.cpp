#include "microstructure_measures.hpp"

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

#include "breccia/microstructure/image_statistics.hpp"
#include "breccia/microstructure/statistics.hpp"
#include "breccia/microstructure/tessellation_statistics.hpp"
#include "breccia/study/coatings.hpp"

#include "shaped_measures.hpp"

namespace breccia {

namespace {

/// The diameter [m] of a disc with the area below which a share of the whole of these areas [m^2] is.
double diameter_below(std::span<const double> rising_areas, double share) {
  const double whole = std::accumulate(rising_areas.begin(), rising_areas.end(), 0.0);
  double below = 0.0;
  const auto found = std::ranges::find_if(rising_areas, [&](double area) { return (below += area) >= share * whole; });
  return 2.0 * std::sqrt(*found / std::numbers::pi);
}

SizesByArea sizes_by_area(const std::vector<GrainGeometry<2>>& grains, double GrainGeometry<2>::*area) {
  if (grains.empty()) return {};
  std::vector<double> areas;
  for (const auto& grain : grains) areas.push_back(grain.*area);
  std::ranges::sort(areas);
  return {diameter_below(areas, 0.1), diameter_below(areas, 0.5)};
}

/// The films between the cells of a tessellation.
struct FilmMeasures {
  double thinnest = std::numeric_limits<double>::infinity();  ///< [m]
  /// Length of the films shorter than five times their thickness over that of all films [-].
  double short_films = 0.0;
};

/// The faces of the cells are in the middle of the films.
FilmMeasures measures_of_films(const Tessellation<2>& tessellation, double film) {
  FilmMeasures result;
  double all = 0.0, in_short_films = 0.0;
  for (std::size_t site = 0; site < tessellation.size(); ++site) {
    const auto& cell = tessellation.cell(site);
    const auto lengths = face_measures(cell);
    for (std::size_t face = 0; face < lengths.size(); ++face) {
      if (!Tessellation<2>::neighbour(cell.half_spaces()[face])) continue;
      const double thickness = 2.0 * tessellation.half_film(site, cell.half_spaces()[face], film);
      result.thinnest = std::min(result.thinnest, thickness);
      all += lengths[face];
      if (lengths[face] < 5.0 * thickness) in_short_films += lengths[face];
    }
  }
  if (all > 0.0) result.short_films = in_short_films / all;
  return result;
}

void measure_grains(StageMicrostructure& result) {
  auto& [sites, film, count, cell_sizes, grain_sizes, short_films] = *result.grains;
  const Tessellation<2> tessellation(sites);
  const auto films = measures_of_films(tessellation, film);
  short_films = films.short_films;
  auto grains = grain_geometries(tessellation, film);
  cell_sizes = sizes_by_area(grains, &GrainGeometry<2>::cell_volume);
  std::erase_if(grains, [](const GrainGeometry<2>& grain) { return !(grain.grain_volume > 0.0); });
  count = grains.size();
  grain_sizes = sizes_by_area(grains, &GrainGeometry<2>::grain_volume);
  double outlines = 0.0;
  for (const auto& grain : grains) outlines += grain.grain_surface;
  result.fraction = grain_fraction(tessellation, film);
  result.interface_per_area = outlines / (sites.side * sites.side);
  result.gap = std::isfinite(films.thinnest) ? films.thinnest : film;
  const bool has_films_along_walls = sites.walls == Walls::hard && sites.wall_film == WallFilm::half;
  result.wall_gap = has_films_along_walls ? 0.5 * film : std::numeric_limits<double>::infinity();
  const auto deviation = result.fillers.empty() ? std::nullopt : result.fillers.front().size_deviation;
  result.fillers = {{.particles = count, .fraction = result.fraction, .size_deviation = deviation}};
  if (grains.empty()) return;
  const auto [smallest, largest] = std::ranges::minmax(grains, {}, &GrainGeometry<2>::diameter);
  result.fillers.front().smallest_diameter = smallest.diameter;
  result.fillers.front().largest_diameter = largest.diameter;
}

void measure_image(const Stage& stage, const LabelImage<2>& image, StageMicrostructure& result) {
  const auto fractions = label_fractions(image, stage.fillers.size() + 1);
  result.fillers.clear();
  for (std::size_t filler = 0; filler < stage.fillers.size(); ++filler) {
    result.fillers.push_back({.fraction = fractions[filler + 1]});
    result.fraction += fractions[filler + 1];
  }
  result.interface_per_area = specific_interface(image);
  // Pixels do not tell one particle from another.
  result.gap = std::numeric_limits<double>::infinity();
  result.wall_gap = std::numeric_limits<double>::infinity();
}

}  // namespace

namespace {

template <int dim>
void measure_balls(const Stage& stage, const Microstructure<dim>& balls, StageMicrostructure& result) {
  const auto coated = with_coatings(stage, balls);
  result.fraction = volume_fraction(balls);
  result.interface_per_area = specific_surface(balls);
  result.gap = smallest_gap(coated);
  result.wall_gap = smallest_wall_gap(coated);
  auto fillers = filler_statistics(stage, balls);
  for (std::size_t number = 0; number < std::min(fillers.size(), result.fillers.size()); ++number) {
    fillers[number].size_deviation = result.fillers[number].size_deviation;
  }
  result.fillers = std::move(fillers);
}

}  // namespace

void measure(const Stage& stage, StageMicrostructure& result) {
  if (const auto* image = stage.image()) {
    measure_image(stage, *image, result);
    return;
  }
  if (result.grains) {
    measure_grains(result);
    return;
  }
  if (result.shaped) {
    measure_shaped(stage, result);
    return;
  }
  if (result.spheres) {
    measure_balls(stage, *result.spheres, result);
  } else {
    measure_balls(stage, result.microstructure, result);
  }
}

}  // namespace breccia
