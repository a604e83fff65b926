#include "microstructure/shapes/particle_locator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "microstructure/vector_algebra.hpp"

namespace breccia {
namespace {

/// Number of buckets along each side, with about one particle a bucket.
int bucket_count(const ParticleBox& box) {
  constexpr double most = 1000.0;
  return static_cast<int>(std::clamp(std::ceil(std::sqrt(static_cast<double>(box.particles.size()))), 1.0, most));
}

}  // namespace

ParticleLocator::ParticleLocator(ParticleBox box)
    : box_(std::move(box)),
      buckets_(bucket_count(box_)),
      reach_(box_.side / buckets_),
      candidates_of_(static_cast<std::size_t>(buckets_) * static_cast<std::size_t>(buckets_)) {
  for_each_image(box_, [&](std::size_t number, const Pose& pose) {
    const auto& shape = box_.particles[number].shape;
    const double radius = circumradius(shape) + box_.coating_of(number);
    Index<2> begin{}, end{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double x = pose.centre()[axis];
      if (x + radius + reach_ < 0.0 || x - radius - reach_ > box_.side) return;
      begin[axis] = bucket_along_axis(x - radius - reach_);
      end[axis] = bucket_along_axis(x + radius + reach_) + 1;
    }
    candidates_.push_back({number, {shape, pose}, radius});
    for_each_index(begin, end, [&](const Index<2>& bucket) {
      candidates_of_[number_of_bucket(bucket)].push_back(candidates_.size() - 1);
    });
  });
}

int ParticleLocator::bucket_along_axis(double coordinate) const {
  return static_cast<int>(std::clamp(std::floor(coordinate / reach_), 0.0, buckets_ - 1.0));
}

std::size_t ParticleLocator::number_of_bucket(const Index<2>& bucket) const {
  return static_cast<std::size_t>(bucket[1]) * static_cast<std::size_t>(buckets_) + static_cast<std::size_t>(bucket[0]);
}

LocatedParticle ParticleLocator::at(const Vector<2>& position) const {
  const auto bucket = number_of_bucket({bucket_along_axis(position[0]), bucket_along_axis(position[1])});
  LocatedParticle nearest = {{}, reach_};
  double coated = reach_;  // distance from the coating of the nearest particle
  for (const auto index : candidates_of_[bucket]) {
    const auto& [number, particle, radius] = candidates_[index];
    if (norm(position - particle.pose.centre()) - radius >= coated) continue;
    const double distance = signed_distance(particle, position);
    const double thickness = box_.coating_of(number);
    if (distance - thickness >= coated) continue;
    coated = distance - thickness;
    nearest = {number, distance};
  }
  return nearest;
}

}  // namespace breccia
