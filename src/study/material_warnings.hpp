#pragma once

#include <optional>
#include <string>
#include <vector>

#include "breccia/study/study.hpp"

namespace breccia {

/// What is doubtful in the materials of a stage that no earlier stage has: a Poisson's ratio below zero at the first or
/// last time, or one of nearly a half at the first time, which a soft binder comes to only as it relaxes.
std::vector<std::string> warnings_on_materials(const Study& study, const Stage& stage);

/// Warns of a filler that is softer than the binder at the bottom of its stage, at the first time.
std::optional<std::string> warning_of_soft_filler(const Study& study, const Stage& stage);

}  // namespace breccia
