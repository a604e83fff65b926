#include "packed_grains.hpp"

#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/io/units.hpp"
#include "breccia/microstructure/draw_diameters.hpp"
#include "breccia/microstructure/random_sites.hpp"
#include "breccia/microstructure/tessellation.hpp"
#include "breccia/study/filler_sizes.hpp"

namespace breccia {
namespace {

/// The sites of the grains: listed, or at random for the sizes of the filler.
template <int dim>
LaguerreSites<dim> sites_of(const Stage& stage, const LaguerrePacking& method, StageMicrostructure& result) {
  if (!method.is_random()) {
    return {stage.side, method.walls, method.sites_in<dim>(), method.wall_film, method.film_shares};
  }
  const auto& filler = stage.fillers.front();
  RandomTessellationRequest request = {.side = stage.side, .walls = method.walls, .diameters = {}, .seed = method.seed};
  if (const auto distribution = distribution_of(filler)) {
    // The cells, grains with half of the films around them, have these sizes.
    constexpr double whole_box = 1.0 - 1e-12;
    request.diameters = draw_diameters<dim>(*distribution, whole_box, stage.side);
    result.fillers.push_back({.size_deviation = largest_deviation<dim>(*distribution, request.diameters)});
  } else {
    request.diameters = std::get<ListedSizes>(filler.sizes.value()).diameters;
  }
  auto sites = random_sites<dim>(request);
  sites.wall_film = method.wall_film;
  return sites;
}

/// The thickness of the films [m].
template <int dim>
double film_between(const LaguerreSites<dim>& sites, const Stage& stage, const LaguerrePacking& method) {
  const Tessellation<dim> tessellation(sites);
  const double film = method.film ? *method.film : film_thickness(tessellation, stage.fillers.front().fraction.value());
  if (grain_fraction(tessellation, film) > 0.0) return film;
  throw InputError(fmt::format(
      "packing.film: films of {} leave nothing of any grain; with films of {} the grains fill half of the box",
      readable(film, Dimension::length), readable(film_thickness(tessellation, 0.5), Dimension::length)));
}

}  // namespace

template <int dim>
Grains<dim> make_grains(const Stage& stage, const LaguerrePacking& method, StageMicrostructure& result) {
  Grains<dim> grains = {sites_of<dim>(stage, method, result)};
  grains.statistics.film = film_between(grains.sites, stage, method);
  return grains;
}

template Grains<2> make_grains(const Stage&, const LaguerrePacking&, StageMicrostructure&);
template Grains<3> make_grains(const Stage&, const LaguerrePacking&, StageMicrostructure&);

}  // namespace breccia
