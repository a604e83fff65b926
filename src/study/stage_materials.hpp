#pragma once

#include <vector>

#include "breccia/study/run.hpp"

namespace breccia {

/// The result of a stage as a material, for every boundary and method of the study: what later stages take as their
/// matrix. `earlier` are the stages that may have made its own. Throws NumericalError where a fit is worse than the
/// study tolerates.
std::vector<StageMaterial> materials_from(const Study& study, const Stage& stage,
                                          const std::vector<StageResult>& earlier, const StageResult& result);

/// The matrix of a stage under a boundary and by a method: a material, or what an earlier stage made of it.
const Material& matrix_of(const Stage& stage, const std::vector<StageResult>& earlier, Boundary boundary,
                          Method method);

/// Of all tests that differ in their grid alone the one that stands for them: extrapolated before the finest grid.
/// Throws InputError when there is none.
const TestResult& representative(const std::vector<TestResult>& tests, Load load, Boundary boundary, Method method);

}  // namespace breccia
