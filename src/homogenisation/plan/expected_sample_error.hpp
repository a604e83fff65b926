#pragma once

#include <optional>
#include <vector>

#include "breccia/homogenisation/filler_statistics.hpp"
#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// The largest error of the sample to be expected of the moduli of a stage, at all times of its tests and before the
/// two shears of its box are known [-] (sample_error, with expected_moduli in place of the moduli). `fillers` are those
/// of its packed box. Nothing where there is no rule for the sample, as with walls or with too few particles.
std::optional<double> expected_sample_error(const Study& study, const Stage& stage,
                                            const std::vector<FillerStatistics>& fillers, const ErrorRules& rules);

}  // namespace breccia
