#include "breccia/microstructure/statistics.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "microstructure/close_pairs.hpp"

namespace breccia {

template <int dim>
double volume_fraction(const Microstructure<dim>& microstructure) {
  double volume = 0.0;
  for (const auto& ball : microstructure.particles) volume += ball_volume<dim>(ball.diameter);
  return volume / times_power<dim>(1.0, microstructure.side);
}

template <int dim>
double specific_surface(const Microstructure<dim>& microstructure) {
  double surface = 0.0;
  for (const auto& ball : microstructure.particles) surface += ball_surface<dim>(ball.diameter);
  return surface / times_power<dim>(1.0, microstructure.side);
}

template <int dim>
double smallest_gap(const Microstructure<dim>& microstructure) {
  return smallest_gap<dim>(microstructure.side, microstructure.walls, microstructure.particles);
}

template <int dim>
double smallest_wall_gap(const Microstructure<dim>& microstructure) {
  double smallest = std::numeric_limits<double>::infinity();
  if (microstructure.walls == Walls::periodic) return smallest;
  for (const auto& ball : microstructure.particles) {
    for (const double x : ball.centre) {
      smallest = std::min(smallest, std::min(x, microstructure.side - x) - 0.5 * ball.diameter);
    }
  }
  return smallest;
}

template <int dim>
std::vector<double> size_histogram(const Microstructure<dim>& microstructure, std::span<const double> edges) {
  if (edges.size() < 2 || !std::ranges::is_sorted(edges, std::ranges::less_equal{})) {
    throw InputError(
        fmt::format("size histogram: needs two or more bin edges that rise strictly, got {}", edges.size()));
  }
  std::vector<double> shares(edges.size() - 1, 0.0);
  double total = 0.0;
  for (const auto& ball : microstructure.particles) {
    const double diameter = ball.diameter;
    const double power = times_power<dim>(1.0, diameter);
    total += power;
    if (diameter < edges.front() || diameter > edges.back()) continue;
    const auto above = static_cast<std::size_t>(std::ranges::upper_bound(edges, diameter) - edges.begin());
    shares[std::min(above, shares.size()) - 1] += power;
  }
  if (total > 0.0) {
    for (double& share : shares) share /= total;
  }
  return shares;
}

template double volume_fraction(const Microstructure<2>&);
template double specific_surface(const Microstructure<2>&);
template double smallest_gap(const Microstructure<2>&);
template double smallest_wall_gap(const Microstructure<2>&);
template std::vector<double> size_histogram(const Microstructure<2>&, std::span<const double>);
template double volume_fraction(const Microstructure<3>&);
template double specific_surface(const Microstructure<3>&);
template double smallest_gap(const Microstructure<3>&);
template double smallest_wall_gap(const Microstructure<3>&);
template std::vector<double> size_histogram(const Microstructure<3>&, std::span<const double>);

}  // namespace breccia
