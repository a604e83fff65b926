#include "microstructure/shapes/growing_particles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "microstructure/shapes/particles_to_place.hpp"
#include "microstructure/uniform.hpp"
#include "microstructure/vector_algebra.hpp"

namespace breccia {
namespace {

// A margin, as a share of the side of the box, that is added to the requested distances so that roundoff does not
// reduce them.
constexpr double margin = 1e-12;

template <class Particle>
std::vector<double> radii_of(const std::vector<Particle>& particles) {
  std::vector<double> radii;
  radii.reserve(particles.size());
  for (const auto& particle : particles) radii.push_back(reach_of(particle) + particle.shell);
  return radii;
}

template <class Particle>
std::vector<std::uint32_t> largest_first(const std::vector<Particle>& particles) {
  std::vector<std::uint32_t> order(particles.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, std::ranges::greater(), [&](std::uint32_t one) { return size_of(particles[one]); });
  return order;
}

}  // namespace

template <class Request>
GrowingParticles<Request>::GrowingParticles(Request request)
    : request_(std::move(request)),
      radii_(radii_of(request_.particles)),
      order_(largest_first(request_.particles)),
      engine_(request_.seed),
      images_(request_.side),
      grid_(request_.side, request_.walls, radii_) {}

template <class Request>
double GrowingParticles<Request>::random() noexcept {
  return uniform(engine_);
}

template <class Request>
typename Request::Pose GrowingParticles<Request>::random_pose(std::uint32_t particle) {
  Vector<dim> centre{};
  for (double& x : centre) x = request_.side * random();
  return posed_at_random(request_.particles[particle], centre, [this] { return random(); });
}

template <class Request>
typename Request::Pose GrowingParticles<Request>::random_move(std::uint32_t particle) {
  // Some moves are small, so that particles which are wedged in can come apart.
  const double share = random();
  const double step = step_ * share * share * share, length = step * scale_ * radii_[particle];
  auto centre = centre_of(poses_[particle]);
  for (double& x : centre) {
    x += length * (2.0 * random() - 1.0);
    if (request_.walls == Walls::periodic) x = wrapped(x, request_.side);
  }
  return turned_a_little(request_.particles[particle], poses_[particle], centre, step, [this] { return random(); });
}

template <class Request>
double GrowingParticles<Request>::overlap_with_walls(std::uint32_t particle, const Pose& pose) const {
  if (request_.walls == Walls::periodic) return 0.0;
  const double wall_distance = request_.particles[particle].wall_distance;
  const double side = request_.side / scale_;
  const auto reach = reach_along_axes(request_.particles[particle], pose);
  double most = 0.0;
  for (std::size_t axis = 0; axis < reach.size(); ++axis) {
    const double x = centre_of(pose)[axis] / scale_;
    const double room = std::min(x - reach[axis][0], side - x - reach[axis][1]);
    most = std::max(most, wall_distance + margin * request_.side - room);
  }
  return most;
}

template <class Request>
typename Request::Pose GrowingParticles<Request>::at_final_size(const Pose& pose, Image image) const {
  return moved_to(pose, (1.0 / scale_) * (centre_of(pose) + images_.shift(image)));
}

template <class Request>
template <class Visit>
void GrowingParticles<Request>::visit_neighbours(std::uint32_t particle, const Pose& pose, Visit&& visit) const {
  grid_.visit_near(centre_of(pose), scale_ * radii_[particle], [&](std::uint32_t other, Image image) {
    if (other == particle && image == PeriodicImages<dim>::in_place) return;
    visit(other, at_final_size(other == particle ? pose : poses_[other], image));
  });
}

template <class Request>
double GrowingParticles<Request>::overlap(std::uint32_t particle, const Pose& pose, double most) const {
  double largest = overlap_with_walls(particle, pose);
  if (largest > most) return largest;
  const auto& particles = request_.particles;
  const double apart = margin * request_.side;
  const auto here = at_final_size(pose, PeriodicImages<dim>::in_place);
  visit_neighbours(particle, pose, [&](std::uint32_t other, const Pose& there) {
    if (largest > most) return;
    if (norm(centre_of(there) - centre_of(here)) >= radii_[particle] + radii_[other] + apart) return;
    const double wanted = particles[particle].shell + particles[other].shell + apart;
    const double gap = gap_between(particles[particle], here, particles[other], there, wanted);
    largest = std::max(largest, wanted - gap);
  });
  return largest;
}

template <class Request>
void GrowingParticles<Request>::move_to(std::uint32_t particle, const Pose& pose) {
  grid_.remove(particle);
  poses_[particle] = pose;
  grid_.insert(particle, centre_of(pose));
}

template <class Request>
bool GrowingParticles<Request>::place(double scale) {
  constexpr int most_tries = 20000;
  scale_ = scale;
  grid_ = LevelGrid<dim>(request_.side, request_.walls, radii_);
  poses_.assign(request_.particles.size(), Pose{{}, {}});
  for (const auto particle : order_) {
    bool has_room = false;
    for (int trial = 0; trial < most_tries && !has_room; ++trial, ++moves_) {
      const auto pose = random_pose(particle);
      has_room = overlap(particle, pose, 0.0) == 0.0;
      if (!has_room) continue;
      poses_[particle] = pose;
      grid_.insert(particle, centre_of(pose));
    }
    if (has_room) continue;
    poses_.clear();
    return false;
  }
  return true;
}

template <class Request>
std::size_t GrowingParticles<Request>::sweep() {
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

/// Adapts the length of the moves such that about two of five are accepted.
template <class Request>
void GrowingParticles<Request>::adapt_step(std::size_t accepted) {
  constexpr double wanted = 0.4, factor = 1.1, smallest = 1e-6, largest = 1.0;
  const bool are_many = static_cast<double>(accepted) > wanted * static_cast<double>(order_.size());
  step_ = std::clamp(are_many ? step_ * factor : step_ / factor, smallest, largest);
}

template <class Request>
void GrowingParticles<Request>::restore(const std::vector<Pose>& poses) {
  for (std::uint32_t particle = 0; particle < poses.size(); ++particle) move_to(particle, poses[particle]);
}

template <class Request>
bool GrowingParticles<Request>::grow_to(double scale, int most_sweeps) {
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

template class GrowingParticles<RandomSequentialRequest>;
template class GrowingParticles<EllipsoidSequentialRequest>;

}  // namespace breccia
