#pragma once

#include <string>
#include <vector>

#include "breccia/study/study.hpp"

namespace breccia {

/// What is known beforehand of the quasi-static tests of cells of a stage, in the words of the keys: that the
/// sizes are too far apart for one box, with the stages between which they could be divided; that a smaller range of
/// moduli takes far less time; and that rounding may keep the tolerance from being met.
std::vector<std::string> remarks_on_tests(const Study& study, const Stage& stage);

}  // namespace breccia
