#include "report/markup.hpp"

namespace breccia {

std::string as_markup(std::string_view text) {
  std::string escaped;
  for (const char sign : text) {
    if (sign == '&') {
      escaped += "&amp;";
    } else if (sign == '<') {
      escaped += "&lt;";
    } else {
      escaped += sign;
    }
  }
  return escaped;
}

}  // namespace breccia
