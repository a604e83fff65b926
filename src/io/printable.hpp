#pragma once

#include <string>
#include <string_view>

namespace breccia {

/// Whether a text has no control character, such as a line break or a tab, and no bytes that are not UTF-8. Other texts
/// can be neither a value of a table nor part of a file name.
bool is_printable(std::string_view text);

/// The text on one line, safe for a terminal: control characters are written as `\u000a`, bytes that are not UTF-8 as
/// `\xe9`.
std::string printable(std::string_view text);

}  // namespace breccia
