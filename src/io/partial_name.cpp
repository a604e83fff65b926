#include "breccia/io/partial_name.hpp"

#include <fmt/format.h>

namespace breccia {
namespace {

constexpr std::string_view ending = ".partial";

}  // namespace

std::string partial_name(std::string_view name, int process) {
  return fmt::format("{}.{}{}", name, process, ending);
}

bool is_partial_name(std::string_view name) {
  if (!name.ends_with(ending)) return false;
  name.remove_suffix(ending.size());
  const auto point = name.rfind('.');
  if (point == std::string_view::npos || point == 0 || name[point - 1] == '/') return false;
  const auto process = name.substr(point + 1);
  return !process.empty() && process.find_first_not_of("0123456789") == std::string_view::npos;
}

}  // namespace breccia
