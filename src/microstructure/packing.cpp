#include "breccia/microstructure/packing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "microstructure/close_pairs.hpp"
#include "microstructure/event_queue.hpp"
#include "microstructure/growing_balls.hpp"

namespace breccia {

namespace {

// Balls are packed larger by this share, so that the gap is kept in spite of roundoff.
constexpr double margin = 1e-9;
// A jammed packing is shrunk until it is a fluid, and grown again at these shares of the growth rate of the request.
constexpr std::array growth_rate_shares = {1.0, 0.2, 0.04};
constexpr double shrinkage = 0.7;

template <int dim>
constexpr const char* balls_word = dim == 2 ? "discs" : "spheres";

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
  const auto is_thickness = [](double shell) { return shell >= 0.0 && std::isfinite(shell); };
  const auto shells = request.shells.size();
  if ((shells != 0 && shells != request.diameters.size()) || !std::ranges::all_of(request.shells, is_thickness)) {
    throw InputError(fmt::format("packing: expected a shell of finite thickness for each of {} particles, or none",
                                 request.diameters.size()));
  }
  if (!(request.growth_rate > 0.0 && request.growth_rate <= 1.0)) {
    throw InputError(
        fmt::format("packing: the growth rate must be above 0 and at most 1, got {}", request.growth_rate));
  }
}

/// The diameters of the particles with their shells and half the gap around each [m]: these must not overlap.
std::vector<double> outer_diameters(const PackingRequest& request) {
  std::vector<double> outer = request.diameters;
  for (double& diameter : outer) diameter += request.minimum_gap;
  for (std::size_t ball = 0; ball < request.shells.size(); ++ball) outer[ball] += 2.0 * request.shells[ball];
  return outer;
}

/// Volume fraction of balls of these diameters [m] in the box of a request.
template <int dim>
double fraction(const PackingRequest& request, const std::vector<double>& diameters) {
  double cubes = 0.0;  // volume of cubes around the balls
  for (const double diameter : diameters) cubes += std::pow(diameter / request.side, dim);
  return cubes * std::numbers::pi / (2.0 * dim);
}

/// Upper bound of the area fraction of discs whose diameters have at least this ratio, smallest to largest: Florian,
/// Rendiconti del Circolo Matematico di Palermo 9 (1960) 300. For equal discs it is the fraction of the hexagonal
/// packing, pi / sqrt(12).
double densest_packing_of_discs(double ratio) {
  return (std::numbers::pi * ratio * ratio + 2.0 * (1.0 - ratio * ratio) * std::asin(ratio / (1.0 + ratio))) /
         (2.0 * ratio * std::sqrt(1.0 + 2.0 * ratio));
}

/// Upper bound of the fraction of balls whose diameters have at least this ratio, smallest to largest.
template <int dim>
double densest_packing(double ratio) {
  if constexpr (dim == 2) return densest_packing_of_discs(ratio);
  // Equal spheres: Hales, Annals of Mathematics 162 (2005) 1065. No bound below 1 is known for all ranges of sizes.
  return ratio == 1.0 ? std::numbers::pi / std::sqrt(18.0) : 1.0;
}

template <int dim>
void require_possible(const PackingRequest& request) {
  const auto [smallest, largest] = std::ranges::minmax(request.diameters);
  const auto [smallest_outer, largest_outer] = std::ranges::minmax(outer_diameters(request));
  const double gap = request.minimum_gap;
  if (largest_outer > request.side) {
    throw PackingError(
        PackingObstacle::size, 0.0,
        fmt::format(
            "packing: a particle of diameter {:.6g} m with a gap of {:.6g} m around it does not fit in a box of "
            "side {:.6g} m",
            largest, gap, request.side));
  }
  const double inflated = inflated_fraction<dim>(request);
  const double densest = densest_packing<dim>(smallest_outer / largest_outer);
  if (inflated <= densest) return;
  throw PackingError(
      PackingObstacle::density, densest,
      fmt::format("packing: {} {} at a fraction of {:.4g} cannot keep a gap of {:.6g} m: with half the gap around each "
                  "they would fill {:.4g} of the box, and {} of {:.6g} m to {:.6g} m can fill at most {:.4g}",
                  request.diameters.size(), balls_word<dim>, fraction<dim>(request, request.diameters), gap, inflated,
                  balls_word<dim>, smallest, largest, densest));
}

/// The unit of length of the growing balls [m]: their mean final diameter, with the gap and the shells.
double unit_length(const PackingRequest& request) {
  const auto count = static_cast<double>(request.diameters.size());
  const auto mean = [count](const std::vector<double>& lengths) {
    return std::accumulate(lengths.begin(), lengths.end(), 0.0) / count;
  };
  return mean(request.diameters) + request.minimum_gap + 2.0 * mean(request.shells);
}

/// Final diameters of the growing balls, with the gap and the shells, in their unit of length.
std::vector<double> inflated_diameters(const PackingRequest& request) {
  const double unit = unit_length(request);
  auto inflated = outer_diameters(request);
  for (double& diameter : inflated) diameter = (1.0 + margin) * diameter / unit;
  return inflated;
}

/// Whether a queue of events holds every ball once, and no ball with an event earlier than that of its parent in the
/// heap.
bool is_queue_of(std::size_t count, const std::vector<std::uint32_t>& balls, const std::vector<double>& times) {
  if (balls.size() != count || times.size() != count) return false;
  std::vector<bool> is_there(count, false);
  for (std::size_t slot = 0; slot < count; ++slot) {
    if (balls[slot] >= count || is_there[balls[slot]]) return false;
    is_there[balls[slot]] = true;
    if (!(times[slot] >= times[EventQueue::above(slot)])) return false;
  }
  return true;
}

/// Whether balls of their present size overlap each other or hard walls. The side of the box is in the unit of length
/// of the balls.
template <int dim>
bool overlap(double side, Walls walls, const PackingState<dim>& state, const std::vector<double>& diameters) {
  constexpr double roundoff = 1e-6;
  if (state.scale == 0.0) return false;
  std::vector<Ball<dim>> balls;
  balls.reserve(diameters.size());
  for (std::size_t ball = 0; ball < diameters.size(); ++ball) {
    balls.push_back({state.positions[ball], state.scale * diameters[ball]});
  }
  const auto is_across_wall = [side](const Ball<dim>& ball) {
    const double least = 0.5 * ball.diameter - roundoff;
    return std::ranges::any_of(ball.centre, [&](double x) { return x < least || side - x < least; });
  };
  if (walls == Walls::hard && std::ranges::any_of(balls, is_across_wall)) return true;
  return smallest_gap<dim>(side, walls, balls) < -roundoff;
}

/// Returns the state, if a run with this request may have saved it. Throws InputError otherwise.
template <int dim>
const PackingState<dim>& sound(const PackingState<dim>& state, const PackingRequest& request) {
  const auto count = request.diameters.size();
  const double side = request.side / unit_length(request);
  const double roundoff = 1e-9 * side;
  const auto is_in_box = [&](const Vector<dim>& position) {
    return std::ranges::all_of(position, [&](double x) { return x >= -roundoff && x <= side + roundoff; });
  };
  const auto is_finite = [](const Vector<dim>& velocity) {
    return std::ranges::all_of(velocity, [](double v) { return std::isfinite(v); });
  };
  const bool is_of_these = state.positions.size() == count && state.velocities.size() == count &&
                           is_queue_of(count, state.queue, state.queue_times);
  const bool has_meaning = state.scale >= 0.0 && state.scale <= 1.0 && state.jams < growth_rate_shares.size();
  if (!is_of_these || !has_meaning || !std::ranges::all_of(state.positions, is_in_box) ||
      !std::ranges::all_of(state.velocities, is_finite) ||
      overlap(side, request.walls, state, inflated_diameters(request))) {
    throw InputError("packing: the state to go on from is not one of these particles in this box");
  }
  return state;
}

/// Makes the growing balls, in their first state or in a later one.
template <int dim, class Start>
std::unique_ptr<GrowingBalls<dim>> growing_balls(const PackingRequest& request, const Start& start) {
  require_meaning(request);
  require_possible<dim>(request);
  return std::make_unique<GrowingBalls<dim>>(request.side / unit_length(request), request.walls,
                                             inflated_diameters(request), start);
}

/// Throws NumericalError where roundoff has let the shells of particles overlap.
template <int dim>
void require_apart(const PackingRequest& request, std::vector<Ball<dim>> balls) {
  if (request.shells.empty()) return;
  for (std::size_t ball = 0; ball < balls.size(); ++ball) balls[ball].diameter += 2.0 * request.shells[ball];
  const double gap = smallest_gap<dim>(request.side, request.walls, balls);
  // Diameters with shells are rounded.
  const double roundoff = 1e-12 * request.side;
  if (gap >= request.minimum_gap - roundoff) return;
  throw NumericalError(fmt::format("packing: roundoff left a gap of {:.9g} m between shells instead of {:.9g} m", gap,
                                   request.minimum_gap));
}

}  // namespace

template <int dim>
double inflated_fraction(const PackingRequest& request) {
  return fraction<dim>(request, outer_diameters(request));
}

template double inflated_fraction<2>(const PackingRequest&);
template double inflated_fraction<3>(const PackingRequest&);

template <int dim>
PackingRun<dim>::PackingRun(PackingRequest request)
    : request_(std::move(request)), balls_(growing_balls<dim>(request_, request_.seed)) {}

template <int dim>
PackingRun<dim>::PackingRun(PackingRequest request, const PackingState<dim>& state)
    : request_(std::move(request)),
      balls_(growing_balls<dim>(request_, sound(state, request_))),
      jams_(state.jams),
      largest_scale_(state.largest_scale) {}

template <int dim>
PackingRun<dim>::PackingRun(PackingRun&&) noexcept = default;
template <int dim>
PackingRun<dim>& PackingRun<dim>::operator=(PackingRun&&) noexcept = default;
template <int dim>
PackingRun<dim>::~PackingRun() = default;

template <int dim>
bool PackingRun<dim>::is_done() const noexcept {
  return balls_->scale() >= 1.0;
}

template <int dim>
void PackingRun<dim>::advance() {
  const double rate = growth_rate_shares[jams_] * request_.growth_rate;
  const double before = balls_->scale();
  balls_->grow(rate);
  const double scale = balls_->scale();
  // Near jamming an epoch achieves only a constant part of the remaining growth, with more and more collisions.
  if (is_done() || scale - before >= 0.01 * rate * (1.0 - scale)) return;
  largest_scale_ = std::max(largest_scale_, scale);
  if (jams_ + 1 < growth_rate_shares.size()) {
    ++jams_;
    balls_->shrink(shrinkage);
    return;
  }
  const double final_fraction = fraction<dim>(request_, request_.diameters);
  const double reached = inflated_fraction<dim>(request_) * std::pow(largest_scale_, dim);
  throw PackingError(
      PackingObstacle::jam, reached,
      fmt::format(
          "packing: {} particles jam at {:.2f} % of their diameters, at a fraction of {:.4g} and a gap of {:.4g} m "
          "instead of {:.4g} and {:.4g} m ({} events); ask for a smaller fraction or gap, or a wider range of sizes",
          request_.diameters.size(), 100.0 * largest_scale_, final_fraction * std::pow(largest_scale_, dim),
          request_.minimum_gap * largest_scale_, final_fraction, request_.minimum_gap, balls_->events()));
}

template <int dim>
PackingProgress PackingRun<dim>::progress() const noexcept {
  const double final_fraction = fraction<dim>(request_, request_.diameters);
  return {balls_->events(), final_fraction * std::pow(balls_->scale(), dim), final_fraction};
}

template <int dim>
PackingState<dim> PackingRun<dim>::state() const {
  PackingState<dim> state;
  state.jams = jams_;
  state.largest_scale = largest_scale_;
  balls_->describe(state);
  return state;
}

template <int dim>
Packing<dim> PackingRun<dim>::packing() const {
  if (!is_done()) throw InputError("packing: the particles have not reached their size");
  const double side = request_.side / unit_length(request_);
  Packing<dim> packing;
  for (std::size_t ball = 0; ball < request_.diameters.size(); ++ball) {
    packing.balls.push_back({balls_->centre(ball), request_.diameters[ball]});
    for (double& x : packing.balls.back().centre) x = x / side * request_.side;
  }
  packing.fraction = fraction<dim>(request_, request_.diameters);
  packing.gap = smallest_gap<dim>(request_.side, request_.walls, packing.balls);
  packing.events = balls_->events();
  require_apart<dim>(request_, packing.balls);
  if (!(packing.gap >= request_.minimum_gap)) {
    throw NumericalError(
        fmt::format("packing: roundoff left a gap of {:.9g} m instead of {:.9g} m", packing.gap, request_.minimum_gap));
  }
  return packing;
}

template class PackingRun<2>;
template class PackingRun<3>;

template <int dim>
Packing<dim> pack(const PackingRequest& request) {
  PackingRun<dim> run(request);
  while (!run.is_done()) run.advance();
  return run.packing();
}

template Packing<2> pack<2>(const PackingRequest&);
template Packing<3> pack<3>(const PackingRequest&);

}  // namespace breccia
