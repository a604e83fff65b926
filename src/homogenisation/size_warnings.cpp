#include "homogenisation/size_warnings.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "breccia/microstructure/ball.hpp"

#include "io/display.hpp"
#include "study/effective_particles.hpp"
#include "study/filler_sizes.hpp"

namespace breccia {
namespace {

/// The filler with the largest particle among those that are drawn from a distribution of sizes.
struct Largest {
  double diameter = 0.0;  ///< [m]
  double asked = 0.0;     ///< the largest size of its distribution [m]
  double ratio = 1.0;     ///< of the largest to the smallest size [-]
};

Largest largest_drawn(const Stage& stage, const StageMicrostructure& packed) {
  Largest found;
  if (stage.has_grains() || stage.fillers.size() != packed.fillers.size()) return found;
  for (std::size_t number = 0; number < stage.fillers.size(); ++number) {
    const auto asked = diameters_of(stage.fillers[number]);
    const double diameter = packed.fillers[number].largest_diameter.value_or(0.0);
    if (!asked || !(asked->smallest < asked->largest) || diameter <= found.diameter) continue;
    found = {diameter, asked->largest, asked->largest / asked->smallest};
  }
  return found;
}

}  // namespace

std::optional<std::string> warning_of_large_particles(const Stage& stage, const StageMicrostructure& packed) {
  // With an effective number of 16 or more no particle is more than a quarter of the filler.
  constexpr double much = 0.25, wide = 8.0, nearly = 0.99;
  const auto largest = largest_drawn(stage, packed);
  const auto effective = effective_particles_of(stage);
  if (!(largest.diameter > 0.0) || !effective) return std::nullopt;
  double filled = 0.0;
  for (const auto& filler : packed.fillers) filled += filler.fraction;
  const bool is_of_space = stage.dimensions() == 3;
  const double volume = is_of_space ? ball_volume<3>(largest.diameter) : ball_volume<2>(largest.diameter);
  const double share = volume / (filled * std::pow(stage.side, stage.dimensions()));
  if (share <= much) return std::nullopt;
  return fmt::format(
      "the box is too small for its sizes: its largest particle, {}, is {:.0f} % of the filler{}; in a box of {} with "
      "some {} particles none is more than a quarter{}",
      display(largest.diameter, "m"), 100.0 * share,
      largest.diameter < nearly * largest.asked
          ? fmt::format(", and those up to {} are missing", display(largest.asked, "m"))
          : "",
      display(std::pow(fewest_effective * effective->volume, 1.0 / stage.dimensions()), "m", 2),
      three_digits(fewest_effective / effective->share),
      largest.ratio > wide ? "; stages, each the matrix of the next, take far fewer" : "");
}

}  // namespace breccia
