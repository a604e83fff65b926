#pragma once

#include <string_view>

namespace breccia {

/// Is the name fit for a stage, and so for its directory on any system? Letters, digits, "-", "_" and ".", the first of
/// them a letter or a digit.
bool is_safe_name(std::string_view name);

/// Does the name lead to an entry of the directory in which it is looked up, and to nothing outside of it?
bool stays_in_directory(std::string_view name);

}  // namespace breccia
