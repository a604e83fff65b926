#pragma once

#include <string>

#include "packing.hpp"

namespace disc_packings {

/// What holds for the displacement u on the sides of the box at the macroscopic strain E or stress S: u - E x is
/// periodic, u is E x, or the traction on the normal n is S n. The latter two are those of a box with walls.
enum class Boundary { periodic, displacement, traction };

[[nodiscard]] Boundary boundary_named(const std::string& name);

[[nodiscard]] Box box_of(Boundary boundary);

}  // namespace disc_packings
