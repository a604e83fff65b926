#pragma once

#include <string>

#include "breccia/study/study.hpp"

#include "study/study_mistakes.hpp"

namespace breccia {

/// Checks a material, which is the given part of a study.
void check_material(const Material& material, const std::string& part, StudyMistakes& mistakes);

/// Checks the named materials of a study, and the shift of each to its temperature.
void check_materials(const Study& study, StudyMistakes& mistakes);

}  // namespace breccia
