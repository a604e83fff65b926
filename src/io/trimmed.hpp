#pragma once

#include <string_view>

namespace breccia::detail {

/// The text without the spaces, tabs and carriage returns around it.
std::string_view trimmed(std::string_view text);

}  // namespace breccia::detail
