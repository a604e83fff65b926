#include "microstructure/tessellation/site_mistakes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"
#include "breccia/microstructure/draw_diameters.hpp"

namespace breccia {

template <int dim>
std::vector<SiteMistake> mistakes_of_numbers(const LaguerreSites<dim>& sites) {
  if (!(sites.side > 0.0) || !std::isfinite(sites.side)) {
    throw InputError(fmt::format("tessellation: the side of the box must be positive, got {} m", sites.side));
  }
  if (sites.sites.empty() || sites.sites.size() > most_particles) {
    throw InputError(
        fmt::format("tessellation: it needs from 1 to {} sites, got {}", most_particles, sites.sites.size()));
  }
  const auto& shares = sites.film_shares;
  if (!shares.empty() && shares.size() != sites.sites.size()) {
    throw InputError(
        fmt::format("tessellation: it needs a share of the films for each of {} sites, or none, got {} of them",
                    sites.sites.size(), shares.size()));
  }
  const auto is_in_box = [&](double x) { return x >= 0.0 && x <= sites.side; };
  std::vector<SiteMistake> found;
  for (std::size_t number = 0; number < sites.sites.size(); ++number) {
    const auto& [position, weight] = sites.sites[number];
    if (!std::ranges::all_of(position, is_in_box)) {
      found.push_back({number, fmt::format("the position ({:.6g} m) is outside the box of side {:.6g} m",
                                           fmt::join(position, " m, "), sites.side)});
    }
    if (!std::isfinite(weight)) found.push_back({number, fmt::format("the weight {} m^2 is not finite", weight)});
    if (!shares.empty() && !(shares[number] > 0.0 && std::isfinite(shares[number]))) {
      found.push_back({number, fmt::format("the share {} of the films is not positive and finite", shares[number])});
    }
  }
  return found;
}

template <int dim>
std::vector<SiteMistake> empty_cells(const LaguerreSites<dim>& sites, const std::vector<ConvexCell<dim>>& cells) {
  std::vector<SiteMistake> found;
  for (std::size_t number = 0; number < cells.size(); ++number) {
    if (!cells[number].is_empty()) continue;
    const auto& [position, weight] = sites.sites[number];
    found.push_back({number, fmt::format("no point belongs to the site at ({:.6g} m) with the weight {:.6g} m^2: a "
                                         "site near it has too large a weight, or the same position",
                                         fmt::join(position, " m, "), weight)});
  }
  return found;
}

void require_none(const std::vector<SiteMistake>& mistakes) {
  constexpr std::size_t most_listed = 20;
  if (mistakes.empty()) return;
  std::string message = "tessellation: these sites make none:";
  for (std::size_t k = 0; k < std::min(most_listed, mistakes.size()); ++k) {
    message += fmt::format("\n  site {}: {}", mistakes[k].site + 1, mistakes[k].text);
  }
  if (mistakes.size() > most_listed) message += fmt::format("\n  and {} more", mistakes.size() - most_listed);
  throw InputError(message);
}

template std::vector<SiteMistake> mistakes_of_numbers(const LaguerreSites<2>&);
template std::vector<SiteMistake> mistakes_of_numbers(const LaguerreSites<3>&);
template std::vector<SiteMistake> empty_cells(const LaguerreSites<2>&, const std::vector<ConvexCell<2>>&);
template std::vector<SiteMistake> empty_cells(const LaguerreSites<3>&, const std::vector<ConvexCell<3>>&);

}  // namespace breccia
