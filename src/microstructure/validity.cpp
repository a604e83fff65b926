#include "breccia/microstructure/validity.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "close_pairs.hpp"

namespace breccia {

namespace {

constexpr std::size_t most_listed = 20;
constexpr double roundoff = 1e-12;  // of a diameter or the side

std::string name(std::size_t disc, const Disc& values) {
  return fmt::format("disc {} (diameter {:.6g} m at {:.6g} m, {:.6g} m)", disc + 1, values.diameter, values.centre[0],
                     values.centre[1]);
}

bool is_inside(double coordinate, double side) {
  return coordinate >= 0.0 && coordinate <= side;
}

/// What is wrong with single discs.
std::vector<std::string> mistakes_of_discs(const Microstructure& microstructure) {
  const double side = microstructure.side;
  std::vector<std::string> mistakes;
  for (std::size_t k = 0; k < microstructure.discs.size(); ++k) {
    const Disc& disc = microstructure.discs[k];
    const auto [x, y] = disc.centre;
    const double room = std::min({x, side - x, y, side - y}) - 0.5 * disc.diameter;
    if (!(disc.diameter > 0.0) || !std::isfinite(disc.diameter)) {
      mistakes.push_back(fmt::format("{}: the diameter must be positive and finite", name(k, disc)));
    } else if (!is_inside(x, side) || !is_inside(y, side)) {
      mistakes.push_back(fmt::format("{}: the centre is outside the box", name(k, disc)));
    } else if (microstructure.walls == Walls::hard && room < -roundoff * side) {
      mistakes.push_back(fmt::format("{}: crosses a wall by {:.3g} m", name(k, disc), -room));
    } else if (microstructure.walls == Walls::periodic && disc.diameter > (1.0 + roundoff) * side) {
      mistakes.push_back(fmt::format("{}: overlaps its own periodic image", name(k, disc)));
    }
  }
  return mistakes;
}

/// Discs that overlap, in the order of their numbers.
std::vector<std::string> overlaps(const Microstructure& microstructure) {
  struct Overlap {
    std::pair<std::uint32_t, std::uint32_t> pair;
    double depth;
  };
  const auto& discs = microstructure.discs;
  std::vector<Overlap> found;
  visit_close_pairs<2>(microstructure.side, microstructure.walls, discs, 0.0,
                       [&](std::uint32_t disc, std::uint32_t other, double gap) {
                         if (-gap <= roundoff * std::max(discs[disc].diameter, discs[other].diameter)) return;
                         found.push_back({std::minmax({disc, other}), -gap});
                       });
  std::ranges::sort(found, {}, &Overlap::pair);
  std::vector<std::string> mistakes;
  mistakes.reserve(found.size());
  for (const auto& [pair, depth] : found) {
    mistakes.push_back(fmt::format("{} and {} overlap by {:.3g} m", name(pair.first, discs[pair.first]),
                                   name(pair.second, discs[pair.second]), depth));
  }
  return mistakes;
}

}  // namespace

void require_valid(const Microstructure& microstructure) {
  if (!(microstructure.side > 0.0) || !std::isfinite(microstructure.side)) {
    throw InputError(
        fmt::format("microstructure: the side of the box must be positive, got {} m", microstructure.side));
  }
  auto mistakes = mistakes_of_discs(microstructure);
  if (mistakes.empty()) mistakes = overlaps(microstructure);
  if (mistakes.empty()) return;
  std::string message =
      fmt::format("microstructure: a box of side {:.6g} m cannot hold these discs:", microstructure.side);
  for (std::size_t k = 0; k < std::min(most_listed, mistakes.size()); ++k) message += "\n  " + mistakes[k];
  if (mistakes.size() > most_listed) message += fmt::format("\n  and {} more", mistakes.size() - most_listed);
  throw InputError(message);
}

}  // namespace breccia
