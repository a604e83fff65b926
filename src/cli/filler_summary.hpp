#pragma once

#include <string>
#include <vector>

#include "breccia/homogenisation/filler_statistics.hpp"
#include "breccia/study/study.hpp"

namespace breccia::cli {

/// A line about the filler of the whole composite for each stage that no other stage builds on, if it has filler.
/// `fractions` are the volume fractions of the particles in the boxes of all stages.
std::string filler_summary(const Study& study, const std::vector<std::vector<FillerStatistics>>& packed);

}  // namespace breccia::cli
