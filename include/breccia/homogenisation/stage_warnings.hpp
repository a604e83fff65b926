#pragma once

#include <optional>
#include <string>
#include <vector>

#include "breccia/homogenisation/stage_microstructure.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// What makes the results of a stage doubtful before anything is computed, each with the name of the stage: a gap that
/// follows the grid, particles too near in size to those of its matrix, gaps that its grid hardly sees, particles that
/// a boundary cuts, times at which the spectrum of its matrix says nothing; and each with the name of the material what
/// is doubtful in the materials that no earlier stage has.
std::vector<std::string> warnings_on(const Study& study, const Stage& stage, const StageMicrostructure& microstructure);

/// Warns of times [s] at which the spectrum of a matrix says nothing; nothing where it does.
std::optional<std::string> warning_of_unknown_times(const Material& matrix, const TimeWindow& times);

}  // namespace breccia
