#pragma once

#include <string_view>

namespace breccia {

/// Whether the name can be that of a stage, and so of a directory on all operating systems: letters, digits, "-", "_"
/// and ".", beginning with a letter or a digit.
bool is_safe_name(std::string_view name);

/// Whether a relative name refers to an entry of its directory, and not to anything outside of it.
bool stays_in_directory(std::string_view name);

/// Whether a part of a name is a number of decimal digits.
bool is_count(std::string_view text);

}  // namespace breccia
