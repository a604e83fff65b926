#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "breccia/discretisation/crystals.hpp"
#include "breccia/study/stage.hpp"

namespace breccia {

/// The orientations of so many particles of a filler, in the order of the box; none where they are isotropic. Throws
/// InputError where a list has another number of them.
[[nodiscard]] std::vector<EulerAngles> crystal_orientations(const Stage& stage, std::size_t filler, std::size_t count);

/// The orientation of each particle of a box, whose numbers of the fillers are given; nothing for those that are
/// isotropic. Throws as crystal_orientations().
[[nodiscard]] std::vector<std::optional<EulerAngles>> orientations_of_particles(const Stage& stage,
                                                                                std::span<const std::size_t> fillers);

/// The stiffness of a crystal of a filler with an orientation, in the axes of the box [Pa].
[[nodiscard]] StiffnessTensor<3> crystal_stiffness(const Crystal& crystal, const EulerAngles& angles);

}  // namespace breccia
