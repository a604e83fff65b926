#pragma once

#include <string>

#include "breccia/study/stage.hpp"

#include "study/study_mistakes.hpp"

namespace breccia {

/// Checks the fillers of a stage and their packing; the stage is the given part of a study.
void check_fillers(const Stage& stage, const std::string& part, StudyMistakes& mistakes);

}  // namespace breccia
