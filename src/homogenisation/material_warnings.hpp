#pragma once

#include <optional>
#include <string>
#include <vector>

#include "breccia/study/study.hpp"

namespace breccia {

/// A warning if the Poisson's ratio of a material is below zero at the first or last time [s], or above 0.49999 before
/// any relaxation (the ratio of a soft binder approaches one half only later); otherwise nothing.
std::optional<std::string> warning_of_poisson_ratio(const Material& material, const TimeWindow& times);

/// These warnings for those materials of a stage that no earlier stage has.
std::vector<std::string> warnings_on_materials(const Study& study, const Stage& stage);

/// A warning for each filler of a stage that is softer than its binder (binder_of) at the first time.
std::vector<std::string> warnings_of_soft_fillers(const Study& study, const Stage& stage);

}  // namespace breccia
