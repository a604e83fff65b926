#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "breccia/microstructure/random_sequential.hpp"

#include "microstructure/level_grid.hpp"
#include "microstructure/periodic_images.hpp"

namespace breccia {

/// The particles of a request for a sequential packing while they grow to their final size. At a scale of s all lengths
/// of the particles and their shells are s times the final ones, as if the box were 1/s times as large.
template <class Request>
class GrowingParticles {
 public:
  static constexpr int dim = Request::dim;
  using Pose = typename Request::Pose;
  using Image = typename PeriodicImages<dim>::Image;

  explicit GrowingParticles(Request request);

  [[nodiscard]] const Request& request() const noexcept { return request_; }
  [[nodiscard]] double scale() const noexcept { return scale_; }
  [[nodiscard]] std::uint64_t moves() const noexcept { return moves_; }
  [[nodiscard]] bool are_placed() const noexcept { return !poses_.empty(); }
  [[nodiscard]] const std::vector<Pose>& poses() const noexcept { return poses_; }

  /// Places the particles at a scale, the largest first. Returns false, with none placed, if one of them does not fit.
  bool place(double scale);
  /// Grows placed particles to a scale, and moves apart those that then overlap. Returns false, and restores the scale
  /// and the poses, if some particles still overlap after the given number of sweeps.
  bool grow_to(double scale, int most_sweeps);

 private:
  [[nodiscard]] double random() noexcept;
  [[nodiscard]] Pose random_pose(std::uint32_t particle);
  /// A pose near that of a particle.
  [[nodiscard]] Pose random_move(std::uint32_t particle);
  /// The pose of a periodic image of a particle in the frame in which particles have their final size, so that the box
  /// is 1 / scale times as large.
  [[nodiscard]] Pose at_final_size(const Pose& pose, Image image) const;
  /// Calls visit(other, pose) for the particles and images near a particle in a pose, with their poses at_final_size().
  template <class Visit>
  void visit_neighbours(std::uint32_t particle, const Pose& pose, Visit&& visit) const;
  /// The largest depth to which a particle in this pose reaches into a shell or a wall [m], at the final size; 0 if it
  /// does not overlap any. Above `most` the value is a lower bound.
  [[nodiscard]] double overlap(std::uint32_t particle, const Pose& pose, double most) const;
  [[nodiscard]] double overlap_with_walls(std::uint32_t particle, const Pose& pose) const;
  void move_to(std::uint32_t particle, const Pose& pose);
  /// Tries a move of each particle; returns the number of particles that still overlap.
  std::size_t sweep();
  void adapt_step(std::size_t accepted);
  void restore(const std::vector<Pose>& poses);

  Request request_;
  std::vector<double> radii_;         // radii of balls around the particles [m]
  std::vector<std::uint32_t> order_;  // numbers of the particles, the largest first
  std::mt19937_64 engine_;
  PeriodicImages<dim> images_;
  LevelGrid<dim> grid_;
  std::vector<Pose> poses_;
  double scale_ = 0.0;
  double step_ = 0.3;  // length of a move, in radii
  std::uint64_t moves_ = 0;
};

extern template class GrowingParticles<RandomSequentialRequest>;
extern template class GrowingParticles<EllipsoidSequentialRequest>;

}  // namespace breccia
