#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "breccia/microstructure/microstructure.hpp"

namespace breccia {

/// What is to be packed, and how.
struct PackingRequest {
  double side = 0.0;  ///< of the box [0, side]^dim [m]
  Walls walls = Walls::hard;
  std::vector<double> diameters;  ///< [m]
  double minimum_gap = 0.0;       ///< between surfaces [m]; half of it to a hard wall
  std::uint64_t seed = 1;         ///< the same seed gives the same packing
  /// Speed at which particles of mean diameter grow in diameter, in units of the speed at which they move. A packing
  /// that jams early is tried again, more slowly. Slow growth packs denser and takes longer.
  double growth_rate = 0.1;
};

/// How far a packing has come.
struct PackingProgress {
  std::uint64_t events;      ///< collisions and other events so far
  double fraction;           ///< volume fraction of the particles at their present size
  double fraction_to_reach;  ///< and at their final size
};
/// Called now and then; packing goes on while it returns true.
using PackingWatch = std::function<bool(const PackingProgress&)>;

template <int dim>
struct Packing {
  std::vector<Ball<dim>> balls;  ///< of the diameters asked for, in the same order
  double fraction = 0.0;         ///< volume fraction
  double gap = 0.0;              ///< smallest between two surfaces [m]; infinite if there are no two
  std::uint64_t events = 0;      ///< that led there
};

/// Places balls at random by the method of Lubachevsky and Stillinger (1990): points with random places and velocities
/// grow, and collide, until they have the diameters asked for.
/// Throws InputError on arguments without meaning, NumericalError if the packing is impossible or jams before the
/// diameters are reached (the message says how far it came), Interrupted if `watch` returns false.
template <int dim>
[[nodiscard]] Packing<dim> pack(const PackingRequest& request, const PackingWatch& watch = {});

extern template Packing<2> pack<2>(const PackingRequest&, const PackingWatch&);

}  // namespace breccia
