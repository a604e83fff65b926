#pragma once

#include <charconv>
#include <string>
#include <system_error>
#include <type_traits>
#include <vector>

#include <fmt/format.h>

namespace examples {

// Reads numbers from arguments, and keeps what is wrong with these.
struct ArgumentReader {
  std::vector<std::string> mistakes = {};

  // An argument that is a number of this kind and within limits.
  template <class Number>
  Number number(const std::string& argument, const char* name, Number least, Number most) {
    const char* const end = argument.data() + argument.size();
    Number value{};
    const auto [rest, error] = std::from_chars(argument.data(), end, value);
    if (error == std::errc() && rest == end && value >= least && value <= most) return value;
    const char* const kind = std::is_integral_v<Number> ? "an integer" : "a number";
    mistakes.push_back(fmt::format("{}: expected {} from {} to {}, got \"{}\"", name, kind, least, most, argument));
    return least;
  }
};

}  // namespace examples
