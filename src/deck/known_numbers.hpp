#pragma once

#include <vector>

namespace breccia {

/// Whether all of these numbers of a deck could be read. Others are NaN and have been reported already.
bool are_known(const std::vector<double>& numbers);

}  // namespace breccia
