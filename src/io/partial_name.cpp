#include "io/partial_name.hpp"

#include <fmt/format.h>

#include "io/safe_name.hpp"

namespace breccia {
namespace {

constexpr std::string_view ending = ".partial";

}  // namespace

std::string partial_name(std::string_view name, int process) {
  return fmt::format("{}.{}{}", name, process, ending);
}

std::string_view whole_name(std::string_view name) {
  if (!name.ends_with(ending)) return {};
  name.remove_suffix(ending.size());
  const auto point = name.rfind('.');
  if (point == std::string_view::npos || point == 0 || name[point - 1] == '/') return {};
  return is_count(name.substr(point + 1)) ? name.substr(0, point) : std::string_view();
}

bool is_partial_name(std::string_view name) {
  return !whole_name(name).empty();
}

}  // namespace breccia
