#pragma once

#include <cstddef>
#include <string_view>

namespace breccia {

/// The longest name of a directory of results: file systems allow 255 bytes.
inline constexpr std::size_t longest_name = 200;

/// Whether the name can be that of a stage, and so of a directory on all operating systems: letters, digits, "-", "_"
/// and ".", beginning with a letter or a digit.
bool is_safe_name(std::string_view name);

/// Whether a relative name refers to an entry of its directory, and not to anything outside of it.
bool stays_in_directory(std::string_view name);

/// Whether a part of a name is a number of decimal digits.
bool is_count(std::string_view text);

}  // namespace breccia
