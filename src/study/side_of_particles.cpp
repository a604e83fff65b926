#include "study/side_of_particles.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/microstructure/ball.hpp"
#include "breccia/microstructure/draw_diameters.hpp"

#include "study/filler_sizes.hpp"

namespace breccia {
namespace {

/// The sizes of a filler and the share of the box that its particles fill.
struct DrawnFiller {
  SizeDistribution sizes;
  double fraction;  ///< [-]
};

/// The particles that are drawn for a box.
struct Draw {
  std::size_t particles = 0;
  double excess = 0.0;  ///< their volume over the volume that is asked for, less one [-]
};

/// Draws the particles of a stage for boxes of any volume.
template <int dim>
class Drawer {
 public:
  explicit Drawer(const Stage& stage) {
    for (const auto& filler : stage.fillers) {
      auto sizes = distribution_of(filler);
      if (!sizes) throw InputError("a number of particles belongs to a distribution of sizes: a list has its own");
      // Grains fill the box, with half of the films around them.
      constexpr double whole_box = 1.0 - 1e-12;
      const double fraction = stage.has_grains() ? whole_box : filler.fraction.value_or(0.0);
      if (!(fraction > 0.0 && fraction < 1.0)) throw InputError("a number of particles belongs to a fraction");
      fillers_.push_back({*std::move(sizes), fraction});
    }
  }

  /// The least volume of a box that holds a particle of each filler [m^dim].
  [[nodiscard]] double least_volume() const {
    constexpr double just_more = 1.0 + 1e-9;
    double volume = 0.0;
    for (const auto& [sizes, fraction] : fillers_) {
      volume = std::max(volume, just_more * 0.5 * ball_volume<dim>(sizes.smallest()) / fraction);
    }
    return volume;
  }

  [[nodiscard]] Draw draw(double volume) const {
    const double side = std::pow(volume, 1.0 / dim);
    Draw drawn;
    double filled = 0.0, asked = 0.0;
    for (const auto& [sizes, fraction] : fillers_) {
      const auto diameters = draw_diameters<dim>(sizes, fraction, side);
      drawn.particles += diameters.size();
      asked += fraction * volume;
      for (const double diameter : diameters) filled += ball_volume<dim>(diameter);
    }
    drawn.excess = filled / asked - 1.0;
    return drawn;
  }

 private:
  std::vector<DrawnFiller> fillers_;
};

/// A volume that draws this number of particles, or at which their number jumps over it [m^dim]. Throws InputError
/// where a box with one particle of each filler holds more.
template <int dim>
double volume_with(const Drawer<dim>& drawer, std::size_t particles) {
  constexpr double growth = 1.2;
  constexpr int most_halvings = 60;
  double low = drawer.least_volume();
  const auto fewest = drawer.draw(low).particles;
  if (fewest > particles) {
    throw InputError(
        fmt::format("{} particles are too few: a box with one of each filler holds {}", particles, fewest));
  }
  double high = low;
  while (drawer.draw(high).particles < particles) low = std::exchange(high, growth * high);
  for (int i = 0; i < most_halvings; ++i) {
    const double middle = 0.5 * (low + high);
    const auto drawn = drawer.draw(middle).particles;
    if (drawn == particles) return middle;
    (drawn < particles ? low : high) = middle;
  }
  return high;
}

/// A volume near this one at which the particles fill what is asked for, or nearly [m^dim]. Between two jumps of their
/// number the volume of the drawn particles hardly changes, so that a box of just this content draws it again.
template <int dim>
double volume_without_excess(const Drawer<dim>& drawer, double volume) {
  constexpr double negligible = 1e-6;
  constexpr int most_steps = 20;
  double best = volume, least = std::numeric_limits<double>::infinity();
  const double smallest = drawer.least_volume();
  for (int step = 0; step < most_steps && least > negligible; ++step) {
    const double excess = drawer.draw(volume).excess;
    if (std::abs(excess) < least) best = volume;
    least = std::min(least, std::abs(excess));
    volume = std::max(smallest, volume * (1.0 + excess));
  }
  return best;
}

/// A length as a user would write it.
double to_six_digits(double value) {
  const auto digits = fmt::format("{:.6g}", value);
  std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return value;
}

template <int dim>
double side_of(const Stage& stage, int particles) {
  const Drawer<dim> drawer(stage);
  const double volume = volume_with(drawer, static_cast<std::size_t>(particles));
  return to_six_digits(std::pow(volume_without_excess(drawer, volume), 1.0 / dim));
}

}  // namespace

int fewest_particles(const Stage& stage) {
  const auto fewest = [](const auto& drawer) { return static_cast<int>(drawer.draw(drawer.least_volume()).particles); };
  return stage.dimensions() == 3 ? fewest(Drawer<3>(stage)) : fewest(Drawer<2>(stage));
}

double side_of_particles(const Stage& stage, int particles) {
  return stage.dimensions() == 3 ? side_of<3>(stage, particles) : side_of<2>(stage, particles);
}

}  // namespace breccia
