#pragma once

#include <array>

#include "breccia/microstructure/microstructure.hpp"
#include "breccia/words.hpp"

namespace breccia {

/// A cubic lattice of equal spheres: the positions of spheres in a cubic cell in addition to the one in its centre.
enum class Lattice {
  simple,        ///< no other position: one sphere a cell, with six nearest neighbours
  body_centred,  ///< the corners of the cell: two spheres a cell, with eight nearest neighbours
  face_centred   ///< the middle of its edges: four spheres a cell, with twelve nearest neighbours
};

template <>
inline constexpr auto words<Lattice> = std::to_array<Word<Lattice>>({{"sc", Lattice::simple},
                                                                     {"bcc", Lattice::body_centred},
                                                                     {"fcc", Lattice::face_centred}});

/// Equal spheres on a cubic lattice in the periodic box [0, side]^3, which `repeats` cells along each axis fill. The
/// sides of the box are planes of symmetry. Lengths in [m]. Throws InputError if a number is not positive or the
/// spheres touch.
[[nodiscard]] Microstructure<3> cubic_array(Lattice lattice, double side, int repeats, double diameter);

/// Diameter [m] with which the spheres of a cubic_array() fill this fraction of the box. Throws InputError if a number
/// is not positive or the spheres touch.
[[nodiscard]] double cubic_array_diameter(Lattice lattice, double side, int repeats, double fraction);

/// Distance between the centres of nearest neighbours in a cubic_array(), in units of the side of a cell [-].
[[nodiscard]] double nearest_distance(Lattice lattice);

}  // namespace breccia
