#include "breccia/microstructure/packing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <numeric>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "close_pairs.hpp"
#include "growing_balls.hpp"

namespace breccia {

namespace {

// Balls are packed larger by this share, so that the gap is kept in spite of roundoff.
constexpr double margin = 1e-9;
// A jammed packing is loosened a little and grown again at these shares of the growth rate asked for.
constexpr std::array slower = {1.0, 0.2, 0.04};
constexpr double loosening = 0.97;

void require_meaning(const PackingRequest& request) {
  if (!(request.side > 0.0) || !std::isfinite(request.side)) {
    throw InputError(fmt::format("packing: the side of the box must be positive, got {} m", request.side));
  }
  if (request.diameters.empty()) throw InputError("packing: there are no particles to pack");
  for (const double diameter : request.diameters) {
    if (!(diameter > 0.0) || !std::isfinite(diameter)) {
      throw InputError(fmt::format("packing: a diameter must be positive and finite, got {} m", diameter));
    }
  }
  if (!(request.minimum_gap >= 0.0) || !std::isfinite(request.minimum_gap)) {
    throw InputError(fmt::format("packing: the gap must be finite and not negative, got {} m", request.minimum_gap));
  }
  if (!(request.growth_rate > 0.0 && request.growth_rate <= 10.0)) {
    throw InputError(
        fmt::format("packing: the growth rate must be above 0 and at most 10, got {}", request.growth_rate));
  }
}

/// Volume fraction of balls whose diameters are all larger by `gap`.
template <int dim>
double fraction(const PackingRequest& request, double gap) {
  double cubes = 0.0;  // around the balls
  for (const double diameter : request.diameters) cubes += std::pow((diameter + gap) / request.side, dim);
  return cubes * std::numbers::pi / (2.0 * dim);
}

/// The densest that discs can be whose diameters have at least this ratio, smallest to largest: Florian, Rendiconti del
/// Circolo Matematico di Palermo 9 (1960) 300. For equal discs the hexagonal packing, pi / sqrt(12).
double densest_packing_of_discs(double ratio) {
  return (std::numbers::pi * ratio * ratio + 2.0 * (1.0 - ratio * ratio) * std::asin(ratio / (1.0 + ratio))) /
         (2.0 * ratio * std::sqrt(1.0 + 2.0 * ratio));
}

template <int dim>
void require_possible(const PackingRequest& request) {
  const auto [smallest, largest] = std::ranges::minmax(request.diameters);
  const double gap = request.minimum_gap;
  if (largest + gap > request.side) {
    throw NumericalError(fmt::format(
        "packing: a particle of diameter {:.6g} m with a gap of {:.6g} m around it does not fit in a box of "
        "side {:.6g} m",
        largest, gap, request.side));
  }
  if constexpr (dim == 2) {
    const double inflated = fraction<dim>(request, gap);
    const double densest = densest_packing_of_discs((smallest + gap) / (largest + gap));
    if (inflated > densest) {
      throw NumericalError(fmt::format(
          "packing: {} discs at a fraction of {:.4g} cannot keep a gap of {:.6g} m: with half the gap around "
          "each they would fill {:.4g} of the box, and discs of {:.6g} m to {:.6g} m can fill at most {:.4g}",
          request.diameters.size(), fraction<dim>(request, 0.0), gap, inflated, smallest, largest, densest));
    }
  }
}

/// Grows the balls to their final size. False if they jam before.
template <int dim>
bool grow_until_jammed(GrowingBalls<dim>& balls, double rate, double final_fraction, const PackingWatch& watch) {
  while (balls.scale() < 1.0) {
    const double before = balls.scale();
    balls.grow(rate);
    const double reached = final_fraction * std::pow(balls.scale(), dim);
    if (watch && !watch({balls.events(), reached, final_fraction})) {
      throw Interrupted(fmt::format("packing interrupted at a fraction of {:.4g} of {:.4g}", reached, final_fraction));
    }
    // Near jamming each epoch brings a constant part of the little way that is left, and collisions without number.
    if (balls.scale() - before < 0.01 * rate * (1.0 - balls.scale())) return false;
  }
  return true;
}

/// Throws NumericalError if the balls jam at every growth rate.
template <int dim>
void grow(GrowingBalls<dim>& balls, const PackingRequest& request, const PackingWatch& watch) {
  const double final_fraction = fraction<dim>(request, 0.0);
  double largest_scale = 0.0;
  for (const double share : slower) {
    if (grow_until_jammed(balls, share * request.growth_rate, final_fraction, watch)) return;
    largest_scale = std::max(largest_scale, balls.scale());
    balls.shrink(loosening);
  }
  throw NumericalError(fmt::format(
      "packing: {} particles jam at {:.2f} % of their diameters, at a fraction of {:.4g} and a gap of {:.4g} m "
      "instead of {:.4g} and {:.4g} m ({} events); ask for a smaller fraction or gap, or a wider range of sizes",
      request.diameters.size(), 100.0 * largest_scale, final_fraction * std::pow(largest_scale, dim),
      request.minimum_gap * largest_scale, final_fraction, request.minimum_gap, balls.events()));
}

}  // namespace

template <int dim>
Packing<dim> pack(const PackingRequest& request, const PackingWatch& watch) {
  require_meaning(request);
  require_possible<dim>(request);

  const auto count = request.diameters.size();
  const double mean_diameter =
      std::accumulate(request.diameters.begin(), request.diameters.end(), 0.0) / static_cast<double>(count) +
      request.minimum_gap;
  std::vector<double> inflated;
  for (const double diameter : request.diameters) {
    inflated.push_back((1.0 + margin) * (diameter + request.minimum_gap) / mean_diameter);
  }
  const double side = request.side / mean_diameter;
  GrowingBalls<dim> growing(side, request.walls, inflated, request.seed);
  grow(growing, request, watch);

  Packing<dim> packing;
  for (std::size_t ball = 0; ball < count; ++ball) {
    packing.balls.push_back({growing.centre(ball), request.diameters[ball]});
    for (double& x : packing.balls.back().centre) x = x / side * request.side;
  }
  packing.fraction = fraction<dim>(request, 0.0);
  packing.gap = smallest_gap<dim>(request.side, request.walls, packing.balls);
  packing.events = growing.events();
  if (packing.gap < request.minimum_gap) {
    throw NumericalError(
        fmt::format("packing: roundoff left a gap of {:.9g} m instead of {:.9g} m", packing.gap, request.minimum_gap));
  }
  return packing;
}

template Packing<2> pack<2>(const PackingRequest&, const PackingWatch&);

}  // namespace breccia
