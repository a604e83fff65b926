#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "breccia/error.hpp"
#include "breccia/microstructure/microstructure.hpp"

namespace breccia {

/// A packing to be made: the particles, the box and the settings of the method.
struct PackingRequest {
  double side = 0.0;  ///< side of the box [0, side]^dim [m]
  Walls walls = Walls::hard;
  std::vector<double> diameters;  ///< [m]
  double minimum_gap = 0.0;       ///< smallest gap between surfaces [m]; half of it to a hard wall
  /// Thickness of a shell around each particle in addition to half the minimum gap [m]: its coating, or the part of its
  /// own gap beyond the smallest one. No two shells overlap. Empty if no particle has a shell.
  std::vector<double> shells = {};
  std::uint64_t seed = 1;  ///< seed of the random numbers; a seed always gives the same packing
  /// Growth rate of the mean diameter, in units of the speed of the particles; at most 1. A packing that jams too early
  /// is repeated with slower growth. Slower growth gives a denser packing and takes longer.
  double growth_rate = 0.1;
};

/// The reason why particles cannot be packed.
enum class PackingObstacle {
  size,     ///< the largest particle, with the gap, is wider than the box
  density,  ///< no arrangement of particles of such sizes is so dense
  jam       ///< the particles jammed at every growth rate
};

/// Error: a packing is impossible.
class PackingError : public NumericalError {
 public:
  PackingError(PackingObstacle obstacle, double attainable_fraction, const std::string& message)
      : NumericalError(message), obstacle_(obstacle), attainable_fraction_(attainable_fraction) {}
  [[nodiscard]] PackingObstacle obstacle() const noexcept { return obstacle_; }
  /// Volume fraction of the particles, each with half the gap around it, at which they jammed, or of their densest
  /// arrangement [-]; 0 where a particle does not fit into the box.
  [[nodiscard]] double attainable_fraction() const noexcept { return attainable_fraction_; }

 private:
  PackingObstacle obstacle_;
  double attainable_fraction_;
};

/// Volume fraction of the particles with half the gap, and their shells, around each.
template <int dim>
[[nodiscard]] double inflated_fraction(const PackingRequest& request);

extern template double inflated_fraction<2>(const PackingRequest&);
extern template double inflated_fraction<3>(const PackingRequest&);

/// Progress of a packing.
struct PackingProgress {
  std::uint64_t events;      ///< collisions and other events so far
  double fraction;           ///< volume fraction at the present size of the particles; falls when a jam is loosened
  double fraction_to_reach;  ///< volume fraction at their final size
};

/// State of an unfinished packing. Together with the request it is sufficient to continue the packing with bitwise
/// identical results. The unit of length is the mean final diameter with the gap; the unit of time makes the mean speed
/// of order one.
template <int dim>
struct PackingState {
  std::size_t jams = 0;                 ///< number of jams that were loosened
  double largest_scale = 0.0;           ///< largest scale at which it has jammed [-]
  double scale = 0.0;                   ///< present size of the particles over their final size [-]
  std::uint64_t events = 0;             ///< number of events so far
  std::vector<Vector<dim>> positions;   ///< positions of the particles
  std::vector<Vector<dim>> velocities;  ///< velocities of the particles
  /// The particles in the order of the heap (priority queue) of events. The order determines which of two colliding
  /// particles is moved first, and so the last digits of the positions.
  std::vector<std::uint32_t> queue;
  std::vector<double> queue_times;  ///< times of the next events of the particles in `queue`
};

template <int dim>
/// The result of a packing.
struct Packing {
  std::vector<Ball<dim>> balls;  ///< balls with the diameters of the request, in the same order
  double fraction = 0.0;         ///< volume fraction
  double gap = 0.0;              ///< smallest gap between two surfaces [m]; infinite if there are no two particles
  std::uint64_t events = 0;      ///< number of events of the packing
};

template <int dim>
class GrowingBalls;

/// Packs balls at random by the method of Lubachevsky and Stillinger (1990): points with random positions and
/// velocities grow and collide until they have the diameters of the request. It runs step by step, so that it can be
/// followed and interrupted.
template <int dim>
class PackingRun {
 public:
  /// Starts a packing. Throws InputError on meaningless arguments, PackingError if the packing is impossible.
  explicit PackingRun(PackingRequest request);
  /// Continues a run with this request from its state. Also throws InputError if the state belongs to another request.
  PackingRun(PackingRequest request, const PackingState<dim>& state);
  PackingRun(PackingRun&&) noexcept;
  PackingRun& operator=(PackingRun&&) noexcept;
  PackingRun(const PackingRun&) = delete;
  PackingRun& operator=(const PackingRun&) = delete;
  ~PackingRun();

  [[nodiscard]] bool is_done() const noexcept;
  /// Runs until the particles have grown by a tenth, or each has had twenty events on average. Throws PackingError,
  /// with the fraction reached, if they jam at every growth rate before they have the diameters of the request.
  void advance();
  [[nodiscard]] PackingProgress progress() const noexcept;
  [[nodiscard]] PackingState<dim> state() const;
  /// The result of the packing. Throws InputError if the run is not done, NumericalError if a gap is too small because
  /// of roundoff.
  [[nodiscard]] Packing<dim> packing() const;

 private:
  PackingRequest request_;
  std::unique_ptr<GrowingBalls<dim>> balls_;
  std::size_t jams_ = 0;
  double largest_scale_ = 0.0;
};

extern template class PackingRun<2>;
extern template class PackingRun<3>;

/// Makes a whole packing in one call. Throws the errors of the members of PackingRun.
template <int dim>
[[nodiscard]] Packing<dim> pack(const PackingRequest& request);

extern template Packing<2> pack<2>(const PackingRequest&);
extern template Packing<3> pack<3>(const PackingRequest&);

}  // namespace breccia
