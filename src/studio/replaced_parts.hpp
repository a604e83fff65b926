#pragma once

#include <string>
#include <string_view>

namespace breccia::studio {

/// The text with each occurrence of a part of it, which is not empty, replaced.
std::string replaced(std::string text, std::string_view part, std::string_view by);

}  // namespace breccia::studio
