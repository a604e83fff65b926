#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "breccia/microstructure/random_sequential.hpp"

#include "level_grid.hpp"
#include "periodic_images.hpp"

namespace breccia {

/// The particles of a request for a sequential packing on their way to their final size. At a scale of s all lengths of
/// the particles and their shells are s times the final ones; so they are as in a box that is 1/s times as large.
template <class Request>
class GrowingParticles {
 public:
  static constexpr int dim = Request::dim;
  using Pose = typename Request::Pose;

  explicit GrowingParticles(Request request);

  [[nodiscard]] const Request& request() const noexcept { return request_; }
  [[nodiscard]] double scale() const noexcept { return scale_; }
  [[nodiscard]] std::uint64_t moves() const noexcept { return moves_; }
  [[nodiscard]] bool are_placed() const noexcept { return !poses_.empty(); }
  [[nodiscard]] const std::vector<Pose>& poses() const noexcept { return poses_; }

  /// Places the particles at a scale, the largest first. False if one of them finds no room; then none is placed.
  bool place(double scale);
  /// Grows placed particles to a scale, and moves those apart that overlap then. False if some do not come apart within
  /// the given number of sweeps; then everything is as before.
  bool grow_to(double scale, int most_sweeps);

 private:
  [[nodiscard]] double random() noexcept;
  [[nodiscard]] Pose random_pose(std::uint32_t particle);
  /// A pose near that of a particle.
  [[nodiscard]] Pose random_move(std::uint32_t particle);
  /// How far a particle in this pose reaches into a shell or a wall [m], at the final size; 0 if it does not. Above
  /// `most` the value is a lower bound.
  [[nodiscard]] double overlap(std::uint32_t particle, const Pose& pose, double most) const;
  [[nodiscard]] double overlap_with_walls(std::uint32_t particle, const Pose& pose) const;
  void move_to(std::uint32_t particle, const Pose& pose);
  /// Tries a move of each particle; returns how many still overlap.
  std::size_t sweep();
  void adapt_step(std::size_t accepted);
  void restore(const std::vector<Pose>& poses);

  Request request_;
  std::vector<double> radii_;         // of balls around the particles [m]
  std::vector<std::uint32_t> order_;  // the largest first
  std::mt19937_64 engine_;
  PeriodicImages<dim> images_;
  LevelGrid<dim> grid_;
  std::vector<Pose> poses_;
  double scale_ = 0.0;
  double step_ = 0.3;  // of a move, in radii
  std::uint64_t moves_ = 0;
};

extern template class GrowingParticles<RandomSequentialRequest>;
extern template class GrowingParticles<EllipsoidSequentialRequest>;

}  // namespace breccia
