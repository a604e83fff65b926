#pragma once

#include <span>
#include <vector>

#include "breccia/microstructure/microstructure.hpp"

namespace breccia {

/// Area of the discs per area of the box.
[[nodiscard]] double area_fraction(const Microstructure& microstructure);

/// Length of the surfaces of the discs per area of the box [1/m]: S/A of the error estimate dG/G ~ S/(A R).
[[nodiscard]] double interface_per_area(const Microstructure& microstructure);

/// Smallest distance between the surfaces of two discs [m], across the sides too if the box is periodic (where a disc
/// also faces its own image). Negative if discs overlap, infinite if there are no two.
[[nodiscard]] double smallest_gap(const Microstructure& microstructure);

/// Smallest distance between a disc and a hard wall [m]. Negative if a disc crosses a wall, infinite if there are no
/// discs or no walls.
[[nodiscard]] double smallest_wall_gap(const Microstructure& microstructure);

/// Share of the discs' area in discs of diameters [edges[k], edges[k+1]); the last bin includes its upper edge. Edges
/// [m] rise strictly. Discs outside them count in the total, so the shares then sum to less than 1. Throws InputError
/// if there are fewer than two edges or they do not rise.
[[nodiscard]] std::vector<double> size_histogram(const Microstructure& microstructure, std::span<const double> edges);

}  // namespace breccia
