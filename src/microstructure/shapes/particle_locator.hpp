#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "breccia/microstructure/particle_box.hpp"

namespace breccia {

/// The particle at or near a point of a box.
struct LocatedParticle {
  /// Number of the particle that contains the point, or whose coated outline is nearest; nothing beyond the reach of
  /// the locator.
  std::optional<std::size_t> particle = {};
  /// Signed distance from the outline of that particle, without its coating (signed_distance()); the reach of the
  /// locator where there is no particle [m].
  double distance = 0.0;
};

/// Finds the particle that contains any point of a box, or one that is near it. The particles must not overlap.
class ParticleLocator {
 public:
  /// The box need not outlive the locator.
  explicit ParticleLocator(ParticleBox box);

  [[nodiscard]] const ParticleBox& box() const noexcept { return box_; }
  /// The particle at a position in the box [m].
  [[nodiscard]] LocatedParticle at(const Vector<2>& position) const;

 private:
  /// A particle or one of its images.
  struct Candidate {
    std::size_t number = 0;
    Particle particle;
    double radius = 0.0;  // radius of a disc around the particle with its coating
  };

  [[nodiscard]] int bucket_along_axis(double coordinate) const;
  [[nodiscard]] std::size_t number_of_bucket(const Index<2>& bucket) const;

  ParticleBox box_;
  int buckets_;   // number of buckets along each side
  double reach_;  // distance beyond which a particle need not be found
  std::vector<Candidate> candidates_;
  std::vector<std::vector<std::size_t>> candidates_of_;  // candidates of each bucket
};

}  // namespace breccia
