#pragma once

#include <string>

namespace breccia {

/// A text with the capital letters of ASCII as small letters.
std::string lower_case(std::string text);

}  // namespace breccia
