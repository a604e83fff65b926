#pragma once

#include <optional>
#include <string>
#include <vector>

#include "breccia/study/study.hpp"

namespace breccia {

/// What is doubtful in the materials of a stage that no earlier stage has: a Poisson's ratio below zero at the first or
/// last time, or one above 0.49999 before any relaxation: a soft binder comes near to a half, but only as it relaxes.
std::vector<std::string> warnings_on_materials(const Study& study, const Stage& stage);

/// Warns of a filler that is softer than the binder at the bottom of its stage, at the first time.
std::optional<std::string> warning_of_soft_filler(const Study& study, const Stage& stage);

}  // namespace breccia
