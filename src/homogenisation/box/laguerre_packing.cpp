#include "homogenisation/box/laguerre_packing.hpp"

#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/microstructure/draw_diameters.hpp"
#include "breccia/microstructure/random_sites.hpp"
#include "breccia/microstructure/tessellation.hpp"

#include "io/units.hpp"
#include "study/filler_sizes.hpp"

namespace breccia {
namespace {

/// Sites at random for the sizes of the filler. Adds the deviation of these sizes.
template <int dim>
LaguerreSites<dim> random_sites_of(const Stage& stage, const LaguerrePacking<dim>& method,
                                   std::vector<std::optional<double>>& size_deviations) {
  const auto& filler = stage.fillers.front();
  RandomTessellationRequest request = {.side = stage.side, .walls = method.walls, .diameters = {}, .seed = method.seed};
  if (const auto distribution = distribution_of(filler)) {
    // The cells, grains with half of the films around them, have these sizes.
    constexpr double whole_box = 1.0 - 1e-12;
    request.diameters = draw_diameters<dim>(*distribution, whole_box, stage.side);
    size_deviations.emplace_back(largest_deviation<dim>(*distribution, request.diameters));
  } else {
    request.diameters = std::get<ListedSizes>(filler.sizes.value()).diameters;
  }
  auto sites = random_sites<dim>(request);
  sites.wall_film = method.wall_film;
  return sites;
}

/// The thickness of the films [m].
template <int dim>
double film_between(const LaguerreSites<dim>& sites, const Stage& stage, const LaguerrePacking<dim>& method) {
  const Tessellation<dim> tessellation(sites);
  const double film = method.film ? *method.film : film_thickness(tessellation, stage.fillers.front().fraction.value());
  if (grain_fraction(tessellation, film) > 0.0) return film;
  throw InputError(fmt::format(
      "packing.film: films of {} leave nothing of any grain; with films of {} the grains fill half of the box",
      readable(film, Dimension::length), readable(film_thickness(tessellation, 0.5), Dimension::length)));
}

}  // namespace

template <int dim>
PlacedBox<dim> placed(const Stage& stage, const LaguerrePacking<dim>& method, PackingRunner&) {
  PlacedBox<dim> result;
  Grains<dim> grains;
  if (method.is_random()) {
    grains.sites = random_sites_of(stage, method, result.size_deviations);
  } else {
    grains.sites = {stage.side, method.walls, method.sites, method.wall_film, method.film_shares};
  }
  grains.statistics.film = film_between(grains.sites, stage, method);
  result.box = std::move(grains);
  return result;
}

template PlacedBox<2> placed(const Stage&, const LaguerrePacking<2>&, PackingRunner&);
template PlacedBox<3> placed(const Stage&, const LaguerrePacking<3>&, PackingRunner&);

}  // namespace breccia
