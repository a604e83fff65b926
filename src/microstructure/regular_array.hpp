#pragma once

#include "breccia/microstructure/index.hpp"
#include "breccia/microstructure/microstructure.hpp"

namespace breccia {

/// Equal balls on a regular lattice: the box [0, side]^dim is divided into `counts` equal parts along each axis, and
/// one ball sits in the middle of each part. Lengths in [m]. Throws InputError if a number is not positive or the balls
/// touch.
template <int dim>
[[nodiscard]] Microstructure<dim> regular_array(double side, const Index<dim>& counts, double diameter,
                                                Walls walls = Walls::hard);

extern template Microstructure<2> regular_array<2>(double, const Index<2>&, double, Walls);
extern template Microstructure<3> regular_array<3>(double, const Index<3>&, double, Walls);

}  // namespace breccia
