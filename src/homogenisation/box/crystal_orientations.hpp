#pragma once

#include <cstddef>
#include <vector>

#include "breccia/discretisation/crystals.hpp"
#include "breccia/study/stage.hpp"

namespace breccia {

/// The orientations of so many crystals of the only filler of a stage; none where its grains are isotropic. Throws
/// InputError where a list has another number of them.
[[nodiscard]] std::vector<EulerAngles> crystal_orientations(const Stage& stage, std::size_t count);

/// The stiffness of each of so many grains in the axes of the box [Pa]; none where they are isotropic.
[[nodiscard]] std::vector<StiffnessTensor<3>> crystal_stiffnesses(const Stage& stage, std::size_t count);

}  // namespace breccia
