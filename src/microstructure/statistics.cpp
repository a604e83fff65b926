#include "breccia/microstructure/statistics.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "close_pairs.hpp"

namespace breccia {

double area_fraction(const Microstructure& microstructure) {
  double area = 0.0;
  for (const Disc& disc : microstructure.discs) area += std::numbers::pi / 4.0 * disc.diameter * disc.diameter;
  return area / (microstructure.side * microstructure.side);
}

double interface_per_area(const Microstructure& microstructure) {
  double length = 0.0;
  for (const Disc& disc : microstructure.discs) length += std::numbers::pi * disc.diameter;
  return length / (microstructure.side * microstructure.side);
}

double smallest_gap(const Microstructure& microstructure) {
  return smallest_gap<2>(microstructure.side, microstructure.walls, microstructure.discs);
}

double smallest_wall_gap(const Microstructure& microstructure) {
  double smallest = std::numeric_limits<double>::infinity();
  if (microstructure.walls == Walls::periodic) return smallest;
  for (const Disc& disc : microstructure.discs) {
    for (const double x : disc.centre) {
      smallest = std::min(smallest, std::min(x, microstructure.side - x) - 0.5 * disc.diameter);
    }
  }
  return smallest;
}

std::vector<double> size_histogram(const Microstructure& microstructure, std::span<const double> edges) {
  if (edges.size() < 2 || !std::ranges::is_sorted(edges, std::ranges::less_equal{})) {
    throw InputError(
        fmt::format("size histogram: needs two or more bin edges that rise strictly, got {}", edges.size()));
  }
  std::vector<double> shares(edges.size() - 1, 0.0);
  double total = 0.0;
  for (const Disc& disc : microstructure.discs) {
    const double squared = disc.diameter * disc.diameter;
    total += squared;
    if (disc.diameter < edges.front() || disc.diameter > edges.back()) continue;
    const auto above = static_cast<std::size_t>(std::ranges::upper_bound(edges, disc.diameter) - edges.begin());
    shares[std::min(above, shares.size()) - 1] += squared;
  }
  if (total > 0.0) {
    for (double& share : shares) share /= total;
  }
  return shares;
}

}  // namespace breccia
