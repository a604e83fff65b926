#include "breccia/microstructure/tessellation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "microstructure/tessellation/cell_builder.hpp"
#include "microstructure/tessellation/site_mistakes.hpp"

namespace breccia {

namespace {

/// The fraction of the box that the grains fill, and its derivative by the thickness of the film [1/m].
struct Filling {
  double fraction = 0.0;
  double slope = 0.0;
};

/// The filling by the grains at a thickness of the film [m]. The derivative follows from the faces of the grains, each
/// of which recedes by half of the growth of its film.
template <int dim>
Filling filling(const Tessellation<dim>& tessellation, double film) {
  const double box = times_power<dim>(1.0, tessellation.side());
  Filling result;
  for (std::size_t site = 0; site < tessellation.size(); ++site) {
    const auto grain = tessellation.grain(site, film);
    const auto faces = face_measures(grain);
    result.fraction += volume(grain) / box;
    for (std::size_t face = 0; face < faces.size(); ++face) {
      result.slope -= tessellation.half_film(site, grain.half_spaces()[face], 1.0) * faces[face] / box;
    }
  }
  return result;
}

}  // namespace

template <int dim>
Tessellation<dim>::Tessellation(LaguerreSites<dim> sites) : sites_(std::move(sites)) {
  require_none(mistakes_of_numbers(sites_));
  cells_ = CellBuilder<dim>(sites_).cells();
  require_none(empty_cells(sites_, cells_));
}

template <int dim>
ConvexCell<dim> Tessellation<dim>::grain(std::size_t site, double film) const {
  return cells_[site].eroded([&](const HalfSpace<dim>& face) { return half_film(site, face, film); });
}

template <int dim>
double Tessellation<dim>::half_film(std::size_t site, const HalfSpace<dim>& face, double film) const {
  if (!recedes(face)) return 0.0;
  if (sites_.film_shares.empty()) return 0.5 * film;
  const auto beyond = neighbour(face).value_or(site);
  return 0.5 * film * std::midpoint(sites_.film_shares[site], sites_.film_shares[beyond]);
}

template <int dim>
std::optional<std::size_t> Tessellation<dim>::neighbour(const HalfSpace<dim>& face) noexcept {
  if (face.behind == Behind<dim>::wall) return std::nullopt;
  return Behind<dim>::site(face.behind);
}

template <int dim>
Index<dim> Tessellation<dim>::image(const HalfSpace<dim>& face) noexcept {
  return face.behind == Behind<dim>::wall ? Index<dim>{} : PeriodicImages<dim>::sides(Behind<dim>::image(face.behind));
}

template <int dim>
std::vector<double> cell_volumes(const Tessellation<dim>& tessellation) {
  std::vector<double> volumes;
  volumes.reserve(tessellation.size());
  for (std::size_t site = 0; site < tessellation.size(); ++site) volumes.push_back(volume(tessellation.cell(site)));
  return volumes;
}

template <int dim>
double grain_fraction(const Tessellation<dim>& tessellation, double film) {
  if (!(film >= 0.0) || !std::isfinite(film)) {
    throw InputError(
        fmt::format("tessellation: the thickness of the film must be finite and not negative, got {} m", film));
  }
  return filling(tessellation, film).fraction;
}

template <int dim>
double film_thickness(const Tessellation<dim>& tessellation, double fraction) {
  if (!(fraction > 0.0 && fraction <= 1.0)) {
    throw InputError(
        fmt::format("tessellation: the fraction of the grains must be above 0 and at most 1, got {}", fraction));
  }
  // Newton steps from a film of zero, kept between the thicknesses that are known to be too small and too large.
  constexpr int most_steps = 200;
  double low = 0.0;
  // An upper bound: no cell is wider than this, and no film has less than the smallest share of the thickness.
  const auto& shares = tessellation.sites().film_shares;
  double high = 2.0 * tessellation.side() / (shares.empty() ? 1.0 : std::ranges::min(shares));
  double film = 0.0;
  for (int count = 0; count < most_steps; ++count) {
    const auto [present, slope] = filling(tessellation, film);
    const double step = (fraction - present) / slope;
    if (std::abs(step) <= 1e-12 * film + 1e-15 * tessellation.side()) return std::max(0.0, film + step);  // roundoff
    (present >= fraction ? low : high) = film;
    film += step;
    if (!(film > low && film < high)) film = std::midpoint(low, high);
  }
  throw NumericalError(fmt::format(
      "tessellation: no thickness of the films was found that leaves the fraction {} to the grains", fraction));
}

template class Tessellation<2>;
template class Tessellation<3>;
template std::vector<double> cell_volumes(const Tessellation<2>&);
template std::vector<double> cell_volumes(const Tessellation<3>&);
template double grain_fraction(const Tessellation<2>&, double);
template double grain_fraction(const Tessellation<3>&, double);
template double film_thickness(const Tessellation<2>&, double);
template double film_thickness(const Tessellation<3>&, double);

}  // namespace breccia
