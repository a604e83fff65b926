#pragma once

#include <string>

#include "breccia/study/filler.hpp"

#include "study_mistakes.hpp"

namespace breccia {

/// Checks the filler of a stage with a box of the given side [m]; it is the given part of a study.
void check_filler(const Filler& filler, double side, const std::string& part, StudyMistakes& mistakes);

}  // namespace breccia
