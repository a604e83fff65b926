#pragma once

#include <array>

#include "breccia/microstructure/microstructure.hpp"
#include "breccia/words.hpp"

namespace breccia {

/// The cubic Bravais lattices.
enum class Lattice {
  simple,         ///< a ball in each cube
  body_centred,   ///< two in each
  face_centred    ///< four in each
};

template <>
inline constexpr auto words<Lattice> = std::to_array<Word<Lattice>>({{"sc", Lattice::simple},
                                                                     {"bcc", Lattice::body_centred},
                                                                     {"fcc", Lattice::face_centred}});

/// Distance of nearest neighbours over the side of the conventional cube [-].
[[nodiscard]] double nearest_distance(Lattice lattice) noexcept;

/// Equal balls on a cubic lattice of `repeats` conventional cubes along each side of a periodic box. Lengths in [m].
/// Throws InputError if a number is not positive or the balls overlap.
[[nodiscard]] Microstructure<3> cubic_array(double side, Lattice lattice, int repeats, double diameter);

}  // namespace breccia
