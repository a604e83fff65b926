#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "breccia/microstructure/ellipsoid.hpp"
#include "breccia/microstructure/packing.hpp"
#include "breccia/microstructure/particle.hpp"

namespace breccia {

/// A plane particle to place.
struct ParticleToPlace {
  Shape shape;
  std::optional<double> angle = {};  ///< of its first axis from the x axis [rad]; without it at random
  /// Thickness of a shell around the particle [m]: its coating and half of its gap. No two shells overlap.
  double shell = 0.0;
  double wall_distance = 0.0;  ///< smallest distance between the particle and a hard wall [m]
};

/// A box, and convex particles of any shape to place in it at random.
struct RandomSequentialRequest {
  static constexpr int dim = 2;
  using Pose = breccia::Pose;

  double side = 0.0;  ///< of the box [0, side]^2 [m]
  Walls walls = Walls::hard;
  std::vector<ParticleToPlace> particles = {};
  std::uint64_t seed = 1;  ///< the same seed gives the same packing
};

/// An ellipsoid to place; all orientations are equally likely.
struct EllipsoidToPlace {
  Vector<3> axes{};    ///< whole lengths [m]
  double shell = 0.0;  ///< as that of ParticleToPlace [m]
  double wall_distance = 0.0;
};

/// Centre and orientation of an ellipsoid.
struct EllipsoidPose {
  Vector<3> centre{};                                       ///< [m]
  std::array<double, 4> quaternion = {1.0, 0.0, 0.0, 0.0};  ///< of the rotation of its axes from x, y and z (turned())
};

/// A box, and ellipsoids to place in it at random.
struct EllipsoidSequentialRequest {
  static constexpr int dim = 3;
  using Pose = EllipsoidPose;

  double side = 0.0;  ///< of the box [0, side]^3 [m]
  Walls walls = Walls::hard;
  std::vector<EllipsoidToPlace> particles = {};
  std::uint64_t seed = 1;  ///< the same seed gives the same packing
};

/// Places particles at random, the largest first, each where it overlaps none (random sequential addition; Feder,
/// Journal of Theoretical Biology 87, 237, 1980). For larger fractions than this can reach, they are placed at a
/// smaller scale and grow by a Monte Carlo compression in steps, between which each moves and turns at random, but
/// never into another one (theory, Eq. 53). It runs step by step, so that it can be followed and interrupted.
/// Instantiated for the particles of a plane and for ellipsoids.
template <class Request>
class SequentialRun {
 public:
  using Pose = typename Request::Pose;

  /// Throws InputError on arguments without meaning, PackingError where a particle does not fit into the box.
  explicit SequentialRun(Request request);
  SequentialRun(SequentialRun&&) noexcept;
  SequentialRun& operator=(SequentialRun&&) noexcept;
  SequentialRun(const SequentialRun&) = delete;
  SequentialRun& operator=(const SequentialRun&) = delete;
  ~SequentialRun();

  [[nodiscard]] bool is_done() const noexcept;
  /// Places all particles, or lets them grow by a step. Throws PackingError when they jam before they have their size:
  /// its attainable_fraction() is that of the particles with their shells.
  void advance();
  /// Events are moves that were tried.
  [[nodiscard]] PackingProgress progress() const noexcept;
  /// The poses of the particles, in the order of the request. Throws InputError if the run is not done.
  [[nodiscard]] const std::vector<Pose>& poses() const;

 private:
  struct Growth;
  void place();

  std::unique_ptr<Growth> growth_;
};

extern template class SequentialRun<RandomSequentialRequest>;
extern template class SequentialRun<EllipsoidSequentialRequest>;

using RandomSequentialRun = SequentialRun<RandomSequentialRequest>;
using EllipsoidSequentialRun = SequentialRun<EllipsoidSequentialRequest>;

}  // namespace breccia
