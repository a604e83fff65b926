#pragma once

#include <string>
#include <vector>

#include "breccia/homogenisation/new_materials.hpp"
#include "breccia/homogenisation/stage_responses.hpp"
#include "breccia/viscoelasticity/shifted_material.hpp"

namespace breccia {

/// The names of the materials of the study that new materials replace, in the order of the new materials. Throws as
/// Responder::with() does.
std::vector<std::string> replaced_materials(const std::vector<NewMaterial>& new_materials,
                                            const std::vector<StageResponses>& stages,
                                            const std::vector<ShiftedMaterial>& of_study);

}  // namespace breccia
