#pragma once

#include <string>
#include <vector>

namespace breccia {

/// Throws InputError with a line for each mistake, if there is one.
void refuse_unless_empty(const std::vector<std::string>& mistakes);

}  // namespace breccia
