#include "breccia/microstructure/random_sequential.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "microstructure/shapes/growing_particles.hpp"
#include "microstructure/shapes/particles_to_place.hpp"

namespace breccia {
namespace {

// The fraction up to which few trials are needed for each particle. Particles that are placed at random one after the
// other fill at most about 55 % of a plane and 38 % of space.
constexpr double placed_fraction(int dim) {
  return dim == 3 ? 0.25 : 0.4;
}
// Relative growth in a step [-]; a step that fails is repeated with half the growth.
constexpr double first_growth = 0.02, largest_growth = 0.05, smallest_growth = 1e-4;
constexpr int most_sweeps = 200;  // largest number of sweeps for a step of growth

template <class Request>
void require_meaning(const Request& request) {
  if (!(request.side > 0.0) || !std::isfinite(request.side)) {
    throw InputError(fmt::format("packing: the side of the box must be positive, got {} m", request.side));
  }
  if (request.particles.empty()) throw InputError("packing: there are no particles to pack");
  for (const auto& particle : request.particles) {
    const double size = size_of(particle);
    if (!(size > 0.0) || !std::isfinite(size)) {
      throw InputError(fmt::format("packing: expected particles with a positive {}, got {} m^{}",
                                   Request::dim == 3 ? "volume" : "area", size, Request::dim));
    }
    const auto is_length = [](double length) { return length >= 0.0 && std::isfinite(length); };
    if (!is_length(particle.shell) || !is_length(particle.wall_distance) || !has_finite_angle(particle)) {
      throw InputError("packing: expected shells and distances that are finite and not negative, and finite angles");
    }
  }
}

/// Whether a particle with its shell fits into the box. In a periodic box it must be shorter than the side, so that it
/// never meets its own images.
template <class Request, class Particle>
bool fits(const Request& request, const Particle& particle) {
  if (request.walls == Walls::periodic) return 2.0 * (reach_of(particle) + particle.shell) < request.side;
  return request.side - least_width(particle) - 2.0 * particle.wall_distance > 0.0;
}

template <class Request>
void require_fitting(const Request& request) {
  const auto unfit =
      std::ranges::find_if_not(request.particles, [&](const auto& particle) { return fits(request, particle); });
  if (unfit == request.particles.end()) return;
  throw PackingError(PackingObstacle::size, 0.0,
                     fmt::format("packing: a particle ({}) with its gap does not fit into a box of side {:.6g} m",
                                 description_of(*unfit), request.side));
}

template <class Request>
double box_of(const Request& request) {
  return times_power<Request::dim>(1.0, request.side);
}

/// Area or volume of the particles per that of the box at their final size.
template <class Request>
double fraction(const Request& request) {
  double sum = 0.0;
  for (const auto& particle : request.particles) sum += size_of(particle);
  return sum / box_of(request);
}

/// Area or volume of the particles with their shells per that of the box at their final size.
template <class Request>
double fraction_with_shells(const Request& request) {
  double sum = 0.0;
  for (const auto& particle : request.particles) sum += size_with_shell(particle);
  return sum / box_of(request);
}

/// Factor of areas (2D) or volumes (3D) where all lengths are multiplied by `scale`.
template <int dim>
double volume_factor(double scale) {
  return times_power<dim>(1.0, scale);
}

/// Factor of the lengths by which areas or volumes are multiplied by `factor`.
template <int dim>
double scale_of(double factor) {
  return dim == 3 ? std::cbrt(factor) : std::sqrt(factor);
}

}  // namespace

/// Growing particles, and the relative growth in the next step.
template <class Request>
struct SequentialRun<Request>::Growth {
  explicit Growth(Request request) : particles(std::move(request)) {}

  GrowingParticles<Request> particles;
  double next = first_growth;  // relative growth of the scale in the next step
};

template <class Request>
SequentialRun<Request>::SequentialRun(Request request) {
  require_meaning(request);
  require_fitting(request);
  growth_ = std::make_unique<Growth>(std::move(request));
}

template <class Request>
SequentialRun<Request>::SequentialRun(SequentialRun&&) noexcept = default;
template <class Request>
SequentialRun<Request>& SequentialRun<Request>::operator=(SequentialRun&&) noexcept = default;
template <class Request>
SequentialRun<Request>::~SequentialRun() = default;

template <class Request>
bool SequentialRun<Request>::is_done() const noexcept {
  return growth_->particles.are_placed() && growth_->particles.scale() >= 1.0;
}

template <class Request>
void SequentialRun<Request>::place() {
  auto& particles = growth_->particles;
  constexpr double smaller = 0.8;
  double scale =
      std::min(1.0, scale_of<Request::dim>(placed_fraction(Request::dim) / fraction_with_shells(particles.request())));
  while (!particles.place(scale)) scale *= smaller;
}

template <class Request>
void SequentialRun<Request>::advance() {
  auto& [particles, next] = *growth_;
  if (!particles.are_placed()) {
    place();
    return;
  }
  if (particles.grow_to(std::min(1.0, particles.scale() * (1.0 + next)), most_sweeps)) {
    next = std::min(1.5 * next, largest_growth);
    return;
  }
  next *= 0.5;
  if (next >= smallest_growth) return;
  const double reached = volume_factor<Request::dim>(particles.scale());
  throw PackingError(
      PackingObstacle::jam, reached * fraction_with_shells(particles.request()),
      fmt::format("packing: {} particles jam at {:.2f} % of their size, at a fraction of {:.4g} instead of {:.4g}",
                  particles.request().particles.size(), 100.0 * particles.scale(),
                  reached * fraction(particles.request()), fraction(particles.request())));
}

template <class Request>
PackingProgress SequentialRun<Request>::progress() const noexcept {
  const auto& particles = growth_->particles;
  const double final_fraction = fraction(particles.request());
  return {particles.moves(), times_power<Request::dim>(final_fraction, particles.scale()), final_fraction};
}

template <class Request>
const std::vector<typename Request::Pose>& SequentialRun<Request>::poses() const {
  if (!is_done()) throw InputError("packing: the particles have not reached their size");
  return growth_->particles.poses();
}

template class SequentialRun<RandomSequentialRequest>;
template class SequentialRun<EllipsoidSequentialRequest>;

}  // namespace breccia
