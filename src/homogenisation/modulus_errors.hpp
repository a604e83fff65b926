#pragma once

#include <vector>

#include "breccia/homogenisation/stage_microstructure.hpp"
#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// Whether an error is what was asked for, or hardly more.
constexpr bool reaches(double error, double asked) noexcept {
  constexpr double hardly_more = 1.02;
  return error <= hardly_more * asked;
}

/// What sample of its material the box of a stage is. Particles and grains are those for which the rule of the scatter
/// was measured: of the plane, and spheres.
SampleKind sample_of(const Study& study, const Stage& stage, const StageMicrostructure& packed);

/// The rules for a stage as it is packed.
ErrorRules error_rules_of(const Study& study, const Stage& stage, const StageMicrostructure& packed);

/// Gives the preferred tests of a stage whose tests are all done the errors of their moduli. `earlier` are the results
/// of the stages before it, with their errors. Throws InputError as matrix_of().
void add_errors(StageFindings& stage, const ErrorRules& rules, const StageMatrix& matrix,
                const std::vector<StageResult>& earlier);

}  // namespace breccia
