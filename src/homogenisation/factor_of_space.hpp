#pragma once

#include <optional>

#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// The ratio of a modulus of random spheres to that of discs of the same fraction, sizes and gaps, at a time.
struct FactorOfSpace {
  double time;   ///< [s]
  double ratio;  ///< [-]
};

/// The largest ratio to be expected of the shear moduli of a stage of random discs without coatings in a periodic
/// box: R^0.25 for a composite that is R times as stiff as its binder (docs/two-or-three-dimensions.md, "Random discs
/// and spheres"), before the binder has relaxed to a millionth. Nothing for other boxes, and for fillers that are not
/// stiffer than the matrix at all times.
std::optional<FactorOfSpace> factor_of_space(const Study& study, const Stage& stage, const StageFindings& result);

}  // namespace breccia
