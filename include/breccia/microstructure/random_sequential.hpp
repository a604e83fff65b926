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

/// A particle to be placed in a plane.
struct ParticleToPlace {
  Shape shape;
  std::optional<double> angle = {};  ///< angle from the x axis to its first axis [rad]; at random if absent
  /// Thickness of a shell around the particle [m]: its coating and half of its gap. No two shells overlap.
  double shell = 0.0;
  double wall_distance = 0.0;  ///< smallest distance between the particle and a hard wall [m]
};

/// A box, and convex particles of any shape to place in it at random.
struct RandomSequentialRequest {
  static constexpr int dim = 2;
  using Pose = breccia::Pose;

  double side = 0.0;  ///< side of the box [0, side]^2 [m]
  Walls walls = Walls::hard;
  std::vector<ParticleToPlace> particles = {};
  std::uint64_t seed = 1;  ///< seed of the random numbers; a seed always gives the same packing
};

/// An ellipsoid to place; all orientations are equally likely.
struct EllipsoidToPlace {
  Vector<3> axes{};    ///< whole lengths of the axes [m]
  double shell = 0.0;  ///< thickness of a shell, as in ParticleToPlace [m]
  double wall_distance = 0.0;
};

/// Centre and orientation of an ellipsoid.
struct EllipsoidPose {
  Vector<3> centre{};  ///< [m]
  /// Quaternion of the rotation of its axes from x, y and z (turned()).
  std::array<double, 4> quaternion = {1.0, 0.0, 0.0, 0.0};
};

/// A box, and ellipsoids to place in it at random.
struct EllipsoidSequentialRequest {
  static constexpr int dim = 3;
  using Pose = EllipsoidPose;

  double side = 0.0;  ///< side of the box [0, side]^3 [m]
  Walls walls = Walls::hard;
  std::vector<EllipsoidToPlace> particles = {};
  std::uint64_t seed = 1;  ///< seed of the random numbers; a seed always gives the same packing
};

/// Places particles at random, the largest first, each at a position where it overlaps no other (random sequential
/// addition; Feder, Journal of Theoretical Biology 87, 237, 1980). For fractions that are too large for this method,
/// the particles are placed at a smaller scale and grow in steps (a Monte Carlo compression); between the steps each
/// particle moves and turns at random without overlapping another (theory, Eq. 53). It runs step by step, so that it
/// can be followed and interrupted. Instantiated for the particles of a plane and for ellipsoids.
template <class Request>
class SequentialRun {
 public:
  using Pose = typename Request::Pose;

  /// Starts a packing. Throws InputError on meaningless arguments, PackingError where a particle does not fit into the
  /// box.
  explicit SequentialRun(Request request);
  SequentialRun(SequentialRun&&) noexcept;
  SequentialRun& operator=(SequentialRun&&) noexcept;
  SequentialRun(const SequentialRun&) = delete;
  SequentialRun& operator=(const SequentialRun&) = delete;
  ~SequentialRun();

  [[nodiscard]] bool is_done() const noexcept;
  /// Places all particles, or lets them grow by a step. Throws PackingError when they jam before they have their full
  /// size; its attainable_fraction() is that of the particles with their shells.
  void advance();
  /// The progress of the packing; its events are the moves that were tried.
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
