#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "breccia/study/stage.hpp"

namespace breccia {

/// Name of the phase that the particles of a stage belong to where all of them are of one material.
inline constexpr std::string_view name_of_filler_phase = "filler";

/// Name of the phase that a material of the fillers or the coatings of a stage makes up: name_of_filler_phase where it
/// is the one material of all fillers, otherwise the name of the material.
std::string phase_of(const Stage& stage, const Material& material);

/// The names of the phases of a stage: first the matrix (name_of_matrix_phase), then one for each material of the
/// fillers, in their order, then one for each material of the coatings that is not among those of the fillers. A name
/// occurs twice only where a material has the name of another phase, which is a mistake (mistakes_of_phases).
std::vector<std::string> phase_names(const Stage& stage);

}  // namespace breccia
