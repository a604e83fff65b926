#pragma once

#include <string>
#include <string_view>

namespace breccia {

/// A text as the content of an element of HTML or XML.
std::string as_markup(std::string_view text);

}  // namespace breccia
