#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "breccia/microstructure/particle_box.hpp"

namespace breccia {

/// The particle at or near a point of a box.
struct LocatedParticle {
  /// The particle that contains the point, or whose coated outline is nearest; none beyond the reach of the locator.
  std::optional<std::size_t> particle = {};
  /// Signed distance from the outline of that particle, without its coating (signed_distance()); the reach of the
  /// locator where there is none [m].
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
    std::size_t number;
    Particle particle;
    double radius;  // of a disc around it with its coating
  };

  [[nodiscard]] int bucket_along_axis(double coordinate) const;

  ParticleBox box_;
  int buckets_;   // along each side
  double reach_;  // farther away a particle need not be found
  std::vector<Candidate> candidates_;
  std::vector<std::vector<std::size_t>> candidates_of_;  // of each bucket
};

}  // namespace breccia
