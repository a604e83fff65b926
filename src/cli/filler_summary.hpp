#pragma once

#include <string>
#include <vector>

#include "breccia/study/study.hpp"

namespace breccia::cli {

/// A line on the filler of the whole for each stage that no other builds on; nothing for those without filler.
/// `fractions` are those of the boxes of all stages.
std::string filler_summary(const Study& study, const std::vector<double>& fractions);

}  // namespace breccia::cli
