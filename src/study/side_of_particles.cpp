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
      if (!stage.has_grains() && !filler.fraction) throw InputError("a number of particles belongs to a fraction");
      fillers_.push_back({*std::move(sizes), stage.has_grains() ? whole_box : *filler.fraction});
    }
  }

  /// The volume of the smallest particle over the fraction [m^dim]: a step of the volume of the box that is small
  /// beside that from one number of particles to the next.
  [[nodiscard]] double smallest_step() const {
    double step = std::numeric_limits<double>::infinity();
    for (const auto& [sizes, fraction] : fillers_) {
      step = std::min(step, ball_volume<dim>(sizes.smallest()) / fraction);
    }
    return step / 8.0;
  }

  /// A volume that draws no more than this number of particles [m^dim].
  [[nodiscard]] double least_volume(int particles) const {
    double volume = std::numeric_limits<double>::infinity();
    for (const auto& [sizes, fraction] : fillers_) {
      volume = std::min(volume, ball_volume<dim>(sizes.smallest()) / fraction);
    }
    return volume * particles / static_cast<double>(fillers_.size());
  }

  [[nodiscard]] Draw draw(double volume) const {
    const double side = std::pow(volume, 1.0 / dim);
    Draw drawn;
    double filled = 0.0, asked = 0.0;
    for (const auto& [sizes, fraction] : fillers_) {
      asked += fraction * volume;
      if (!(fraction * volume > 0.5 * ball_volume<dim>(sizes.smallest()))) continue;
      const auto diameters = draw_diameters<dim>(sizes, fraction, side);
      drawn.particles += diameters.size();
      for (const double diameter : diameters) filled += ball_volume<dim>(diameter);
    }
    drawn.excess = filled / asked - 1.0;
    return drawn;
  }

 private:
  std::vector<DrawnFiller> fillers_;
};

constexpr int most_halvings = 60;

/// A volume that draws this number of particles, or at which their number jumps over it [m^dim].
template <int dim>
double volume_with(const Drawer<dim>& drawer, std::size_t particles, double least) {
  constexpr double growth = 1.2;
  double low = least, high = least;
  while (drawer.draw(high).particles < particles) low = std::exchange(high, growth * high);
  for (int i = 0; i < most_halvings; ++i) {
    const double middle = 0.5 * (low + high);
    const auto drawn = drawer.draw(middle).particles;
    if (drawn == particles) return middle;
    (drawn < particles ? low : high) = middle;
  }
  return high;
}

/// The volume nearest to `volume` at which the particles fill just what is asked for [m^dim]. Between two jumps of
/// their number the excess falls from half of the smallest particle above to half of it below.
template <int dim>
double volume_without_excess(const Drawer<dim>& drawer, double volume) {
  constexpr double negligible = 1e-6;
  const double step = drawer.smallest_step();
  double low = volume, high = volume;
  while (drawer.draw(low).excess < 0.0) low -= step;
  while (drawer.draw(high).excess > 0.0) high += step;
  for (int i = 0; i < most_halvings; ++i) {
    const double middle = 0.5 * (low + high);
    const double excess = drawer.draw(middle).excess;
    if (std::abs(excess) < negligible) return middle;
    (excess > 0.0 ? low : high) = middle;
  }
  return low;
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
  const double volume = volume_with(drawer, static_cast<std::size_t>(particles), drawer.least_volume(particles));
  return to_six_digits(std::pow(volume_without_excess(drawer, volume), 1.0 / dim));
}

}  // namespace

double side_of_particles(const Stage& stage, int particles) {
  return stage.dimensions() == 3 ? side_of<3>(stage, particles) : side_of<2>(stage, particles);
}

}  // namespace breccia
