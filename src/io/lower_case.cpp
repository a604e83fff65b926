#include "io/lower_case.hpp"

#include <cctype>

namespace breccia {

std::string lower_case(std::string text) {
  for (auto& letter : text) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return text;
}

}  // namespace breccia
