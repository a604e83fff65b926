#pragma once

#include <cstddef>
#include <string_view>

namespace breccia::detail {

/// The number of bytes of the UTF-8 character with which a text begins; 0 where these bytes are not UTF-8.
std::size_t length_of_character(std::string_view text);

}  // namespace breccia::detail
