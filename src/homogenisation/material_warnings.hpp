#pragma once

#include <optional>
#include <string>
#include <vector>

#include "breccia/study/study.hpp"

namespace breccia {

// The abscissa is that of the study, of which a warning speaks: of a time or of the frequency that belongs to it.

/// A warning if the Poisson's ratio of a material is below zero at the first or last time [s], or above 0.49999 before
/// any relaxation (the ratio of a soft binder approaches one half only later); otherwise nothing.
std::optional<std::string> warning_of_poisson_ratio(const Material& material, const TimeWindow& times,
                                                    Abscissa abscissa);

/// Warnings if some of the times [s] are before or after the relaxation spectrum of a matrix.
std::vector<std::string> warnings_of_unknown_times(const Material& matrix, const TimeWindow& times, Abscissa abscissa);

/// A warning if the shear or bulk modulus of a filler is below that of the binder at a time [s]; otherwise nothing.
std::optional<std::string> warning_of_soft_filler(const Material& filler, const Material& binder, double time,
                                                  Abscissa abscissa);

/// The warnings of warning_of_poisson_ratio() for the materials of a stage that no earlier stage has.
std::vector<std::string> warnings_on_materials(const Study& study, const Stage& stage);

/// A warning for each filler of a stage that is softer than its binder (binder_of) at the first time.
std::vector<std::string> warnings_of_soft_fillers(const Study& study, const Stage& stage);

}  // namespace breccia
