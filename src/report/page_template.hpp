#pragma once

#include <string_view>

namespace breccia {

/// `page/page.html` with its style, its scripts and the plotting library in it. Made when the program is built.
std::string_view page_template();

}  // namespace breccia
