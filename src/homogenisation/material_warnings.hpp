#pragma once

#include <string>
#include <vector>

#include "breccia/study/study.hpp"

namespace breccia {

/// Warnings about those materials of a stage that no earlier stage has: a Poisson's ratio below zero at the first or
/// last time, or above 0.49999 before any relaxation (the ratio of a soft binder approaches one half only later).
std::vector<std::string> warnings_on_materials(const Study& study, const Stage& stage);

/// A warning for each filler of a stage that is softer than its binder (binder_of) at the first time.
std::vector<std::string> warnings_of_soft_fillers(const Study& study, const Stage& stage);

}  // namespace breccia
