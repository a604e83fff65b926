#pragma once

#include <cstddef>
#include <string_view>

namespace breccia::detail {

/// The number of bytes of the first UTF-8 character of a text; 0 if the text does not begin with UTF-8.
std::size_t length_of_character(std::string_view text);

}  // namespace breccia::detail
