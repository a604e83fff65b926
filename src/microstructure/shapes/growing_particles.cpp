#include "growing_particles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include "uniform.hpp"
#include "vector_algebra.hpp"

namespace breccia {
namespace {

// Particles keep apart by so much of the side of the box more than they must, so that roundoff takes nothing from it.
constexpr double margin = 1e-12;

std::vector<double> radii_of(const std::vector<ParticleToPlace>& particles) {
  std::vector<double> radii;
  for (const auto& particle : particles) radii.push_back(circumradius(particle.shape) + particle.shell);
  return radii;
}

std::vector<std::uint32_t> largest_first(const std::vector<ParticleToPlace>& particles) {
  std::vector<std::uint32_t> order(particles.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, std::ranges::greater(),
                           [&](std::uint32_t one) { return area(particles[one].shape); });
  return order;
}

Vector<2> scaled(const Vector<2>& vector, double factor) {
  return {factor * vector[0], factor * vector[1]};
}

}  // namespace

GrowingParticles::GrowingParticles(RandomSequentialRequest request)
    : request_(std::move(request)),
      radii_(radii_of(request_.particles)),
      order_(largest_first(request_.particles)),
      engine_(request_.seed),
      images_(request_.side),
      grid_(request_.side, request_.walls, radii_) {}

double GrowingParticles::random() noexcept {
  return uniform(engine_);
}

Pose GrowingParticles::random_pose(std::uint32_t particle) {
  const Vector<2> centre = {request_.side * random(), request_.side * random()};
  const double angle = 2.0 * std::numbers::pi * random();
  return {centre, request_.particles[particle].angle.value_or(angle)};
}

Pose GrowingParticles::random_move(std::uint32_t particle) {
  // Some moves are small: those that part particles which are wedged in.
  const double share = random();
  const double step = step_ * share * share * share, length = step * scale_ * radii_[particle];
  auto centre = poses_[particle].centre();
  for (double& x : centre) {
    x += length * (2.0 * random() - 1.0);
    if (request_.walls == Walls::periodic) x = wrapped(x, request_.side);
  }
  const double turn = step * (2.0 * random() - 1.0);
  return {centre, request_.particles[particle].angle.value_or(poses_[particle].angle() + turn)};
}

double GrowingParticles::overlap_with_walls(std::uint32_t particle, const Pose& pose) const {
  if (request_.walls == Walls::periodic) return 0.0;
  const auto& [shape, angle, shell, wall_distance] = request_.particles[particle];
  const double side = request_.side / scale_;
  const auto reach = extent(shape, pose);
  double most = 0.0;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double x = pose.centre()[axis] / scale_;
    const double room = std::min(x - reach[axis][0], side - x - reach[axis][1]);
    most = std::max(most, wall_distance + margin * request_.side - room);
  }
  return most;
}

double GrowingParticles::overlap(std::uint32_t particle, const Pose& pose, double most) const {
  double largest = overlap_with_walls(particle, pose);
  if (largest > most) return largest;
  const auto& shape = request_.particles[particle].shape;
  const auto here = pose.at(scaled(pose.centre(), 1.0 / scale_));
  grid_.visit_near(pose.centre(), scale_ * radii_[particle], [&](std::uint32_t other, std::uint32_t image) {
    if (largest > most || (other == particle && image == PeriodicImages<2>::in_place)) return;
    const auto& neighbour = other == particle ? pose : poses_[other];
    const auto centre = scaled(displaced(neighbour.centre(), 1.0, images_.shift(image)), 1.0 / scale_);
    const double apart = norm(difference(centre, here.centre()));
    if (apart >= radii_[particle] + radii_[other] + margin * request_.side) return;
    const double wanted = request_.particles[particle].shell + request_.particles[other].shell + margin * request_.side;
    const double width = gap(shape, here, request_.particles[other].shape, neighbour.at(centre), wanted).width;
    largest = std::max(largest, wanted - width);
  });
  return largest;
}

void GrowingParticles::move_to(std::uint32_t particle, const Pose& pose) {
  grid_.remove(particle);
  poses_[particle] = pose;
  grid_.insert(particle, pose.centre());
}

bool GrowingParticles::place(double scale) {
  constexpr int most_tries = 20000;
  scale_ = scale;
  grid_ = LevelGrid<2>(request_.side, request_.walls, radii_);
  poses_.assign(request_.particles.size(), Pose({0.0, 0.0}, 0.0));
  for (const auto particle : order_) {
    bool has_room = false;
    for (int trial = 0; trial < most_tries && !has_room; ++trial, ++moves_) {
      const auto pose = random_pose(particle);
      has_room = overlap(particle, pose, 0.0) == 0.0;
      if (!has_room) continue;
      poses_[particle] = pose;
      grid_.insert(particle, pose.centre());
    }
    if (has_room) continue;
    poses_.clear();
    return false;
  }
  return true;
}

std::size_t GrowingParticles::sweep() {
  std::size_t overlapping = 0, accepted = 0;
  for (const auto particle : order_) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const double before = overlap(particle, poses_[particle], infinite);
    const auto pose = random_move(particle);
    ++moves_;
    const double after = overlap(particle, pose, before);
    const bool is_better = after < before || after == 0.0;
    if (is_better) {
      move_to(particle, pose);
      ++accepted;
    }
    if ((is_better ? after : before) > 0.0) ++overlapping;
  }
  adapt_step(accepted);
  return overlapping;
}

/// About two of five moves shall be possible.
void GrowingParticles::adapt_step(std::size_t accepted) {
  constexpr double wanted = 0.4, factor = 1.1, smallest = 1e-6, largest = 1.0;
  const bool are_many = static_cast<double>(accepted) > wanted * static_cast<double>(order_.size());
  step_ = std::clamp(are_many ? step_ * factor : step_ / factor, smallest, largest);
}

void GrowingParticles::restore(const std::vector<Pose>& poses) {
  for (std::uint32_t particle = 0; particle < poses.size(); ++particle) move_to(particle, poses[particle]);
}

bool GrowingParticles::grow_to(double scale, int most_sweeps) {
  const auto poses = poses_;
  const double before = std::exchange(scale_, scale);
  for (int count = 0; count < most_sweeps; ++count) {
    // A particle that has come apart from another one may have been counted before that one moved.
    if (sweep() == 0) return true;
  }
  restore(poses);
  scale_ = before;
  return false;
}

}  // namespace breccia
