#include "breccia/microstructure/random_sequential.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "growing_particles.hpp"
#include "particle_pairs.hpp"

namespace breccia {
namespace {

// Particles that are placed at random one after the other reach about 55 % of a plane; up to this share each of them
// finds room soon.
constexpr double placed_fraction = 0.4;
// Growth in a step [-]; a step that fails is repeated with half of it.
constexpr double first_growth = 0.02, largest_growth = 0.05, smallest_growth = 1e-4;
constexpr int most_sweeps = 200;  // for a step of growth

void require_meaning(const RandomSequentialRequest& request) {
  if (!(request.side > 0.0) || !std::isfinite(request.side)) {
    throw InputError(fmt::format("packing: the side of the box must be positive, got {} m", request.side));
  }
  if (request.particles.empty()) throw InputError("packing: there are no particles to pack");
  for (const auto& [shape, angle, shell, wall_distance] : request.particles) {
    const double size = area(shape);
    if (!(size > 0.0) || !std::isfinite(size)) {
      throw InputError(fmt::format("packing: expected particles with a positive area, got {} m^2", size));
    }
    const auto is_length = [](double length) { return length >= 0.0 && std::isfinite(length); };
    if (!is_length(shell) || !is_length(wall_distance) || !std::isfinite(angle.value_or(0.0))) {
      throw InputError("packing: expected shells and distances that are finite and not negative, and finite angles");
    }
  }
}

/// Room that a particle has between the walls in this orientation [m]; negative where it does not fit.
double room(const RandomSequentialRequest& request, const ParticleToPlace& particle, double angle) {
  const Pose pose({0.0, 0.0}, angle);
  const auto reach = extent(particle.shape, pose);
  const double width = std::max(reach[0][0] + reach[0][1], reach[1][0] + reach[1][1]);
  return request.side - width - 2.0 * particle.wall_distance;
}

/// In a periodic box a particle is no longer than the box, so that it never meets its own images.
bool fits(const RandomSequentialRequest& request, const ParticleToPlace& particle) {
  if (request.walls == Walls::periodic) {
    return 2.0 * (circumradius(particle.shape) + particle.shell) < request.side;
  }
  if (particle.angle) return room(request, particle, *particle.angle) > 0.0;
  constexpr int angles = 180;
  for (int step = 0; step < angles; ++step) {
    if (room(request, particle, 2.0 * std::numbers::pi * step / angles) > 0.0) return true;
  }
  return false;
}

void require_room(const RandomSequentialRequest& request) {
  const auto unfit = std::ranges::find_if_not(request.particles,
                                              [&](const ParticleToPlace& particle) { return fits(request, particle); });
  if (unfit == request.particles.end()) return;
  throw PackingError(PackingObstacle::size, 0.0,
                     fmt::format("packing: a particle ({}) with its gap does not fit into a box of side {:.6g} m",
                                 in_words(unfit->shape), request.side));
}

/// Area of the particles per area of the box at their final size.
double fraction(const RandomSequentialRequest& request) {
  double sum = 0.0;
  for (const auto& particle : request.particles) sum += area(particle.shape);
  return sum / (request.side * request.side);
}

/// The same with their shells.
double fraction_with_shells(const RandomSequentialRequest& request) {
  double sum = 0.0;
  for (const auto& [shape, angle, shell, wall_distance] : request.particles) {
    sum += area(shape) + shell * perimeter(shape) + std::numbers::pi * shell * shell;
  }
  return sum / (request.side * request.side);
}

}  // namespace

/// Growing particles, with the growth of the next step.
struct RandomSequentialRun::Growth {
  explicit Growth(RandomSequentialRequest request) : particles(std::move(request)) {}

  GrowingParticles particles;
  double next = first_growth;  // of the scale
};

RandomSequentialRun::RandomSequentialRun(RandomSequentialRequest request) {
  require_meaning(request);
  require_room(request);
  growth_ = std::make_unique<Growth>(std::move(request));
}

RandomSequentialRun::RandomSequentialRun(RandomSequentialRun&&) noexcept = default;
RandomSequentialRun& RandomSequentialRun::operator=(RandomSequentialRun&&) noexcept = default;
RandomSequentialRun::~RandomSequentialRun() = default;

bool RandomSequentialRun::is_done() const noexcept {
  return growth_->particles.are_placed() && growth_->particles.scale() >= 1.0;
}

void RandomSequentialRun::place() {
  auto& particles = growth_->particles;
  constexpr double smaller = 0.8;
  double scale = std::min(1.0, std::sqrt(placed_fraction / fraction_with_shells(particles.request())));
  while (!particles.place(scale)) scale *= smaller;
}

void RandomSequentialRun::advance() {
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
  const double reached = particles.scale() * particles.scale();
  throw PackingError(
      PackingObstacle::jam, reached * fraction_with_shells(particles.request()),
      fmt::format("packing: {} particles jam at {:.2f} % of their size, at a fraction of {:.4g} instead of {:.4g}",
                  particles.request().particles.size(), 100.0 * particles.scale(),
                  reached * fraction(particles.request()), fraction(particles.request())));
}

PackingProgress RandomSequentialRun::progress() const noexcept {
  const auto& particles = growth_->particles;
  const double final_fraction = fraction(particles.request());
  return {particles.moves(), final_fraction * particles.scale() * particles.scale(), final_fraction};
}

const std::vector<Pose>& RandomSequentialRun::poses() const {
  if (!is_done()) throw InputError("packing: the particles have not reached their size");
  return growth_->particles.poses();
}

}  // namespace breccia
