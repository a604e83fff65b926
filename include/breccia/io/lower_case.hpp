#pragma once

#include <string>

namespace breccia {

/// A text with small letters in the place of the capitals of ASCII.
std::string lower_case(std::string text);

}  // namespace breccia
