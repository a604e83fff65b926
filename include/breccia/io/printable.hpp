#pragma once

#include <string>
#include <string_view>

namespace breccia {

/// False for a text with a control character, such as a line break or a tab, or with bytes that are not UTF-8: it can
/// be neither a value of a table nor part of the name of a file.
bool is_printable(std::string_view text);

/// The text on one line, harmless to a terminal: control characters as \u000a, bytes that are not UTF-8 as \xe9.
std::string printable(std::string_view text);

}  // namespace breccia
