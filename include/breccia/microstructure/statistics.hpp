#pragma once

#include <span>
#include <vector>

#include "breccia/microstructure/microstructure.hpp"

namespace breccia {

// Instantiated for 2 and 3 dimensions. In 2D a volume is an area and a surface a length.

/// Volume of the particles per volume of the box.
template <int dim>
[[nodiscard]] double volume_fraction(const Microstructure<dim>& microstructure);

/// Surface of the particles per volume of the box [1/m]: S/A of the error estimate dG/G ~ S/(A R).
template <int dim>
[[nodiscard]] double specific_surface(const Microstructure<dim>& microstructure);

/// Smallest distance between the surfaces of two particles [m], across the sides too if the box is periodic (where a
/// particle also faces its own image). Negative if particles overlap, infinite if there are no two.
template <int dim>
[[nodiscard]] double smallest_gap(const Microstructure<dim>& microstructure);

/// Smallest distance between a particle and a hard wall [m]. Negative if a particle crosses a wall, infinite if there
/// are no particles or no walls.
template <int dim>
[[nodiscard]] double smallest_wall_gap(const Microstructure<dim>& microstructure);

/// Share of the particles' volume in particles of diameters [edges[k], edges[k+1]); the last bin includes its upper
/// edge. Edges [m] rise strictly. Particles outside them count in the total, so the shares then sum to less than 1.
/// Throws InputError if there are fewer than two edges or they do not rise.
template <int dim>
[[nodiscard]] std::vector<double> size_histogram(const Microstructure<dim>& microstructure,
                                                 std::span<const double> edges);

}  // namespace breccia
