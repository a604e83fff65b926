#include "io/safe_name.hpp"

#include <algorithm>
#include <cctype>

namespace breccia {

namespace {

bool is_letter_or_digit(char sign) {
  return std::isalnum(static_cast<unsigned char>(sign)) != 0;
}

}  // namespace

bool is_safe_name(std::string_view name) {
  const auto is_allowed = [](char sign) {
    return is_letter_or_digit(sign) || sign == '-' || sign == '_' || sign == '.';
  };
  return !name.empty() && is_letter_or_digit(name.front()) && std::ranges::all_of(name, is_allowed);
}

bool stays_in_directory(std::string_view name) {
  constexpr std::string_view separators("/\\\0", 3);
  return !name.empty() && name != "." && name != ".." && name.find_first_of(separators) == std::string_view::npos;
}

bool is_count(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

}  // namespace breccia
