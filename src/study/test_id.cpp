#include "breccia/study/test_id.hpp"

#include <charconv>
#include <system_error>
#include <utility>

namespace breccia {
namespace {

constexpr std::string_view name_of_limit = "extrapolated";

}  // namespace

std::string name_of(TestGrid grid) {
  const auto cells = grid.cells();
  return cells ? std::to_string(*cells) : std::string(name_of_limit);
}

std::optional<TestGrid> grid_named(std::string_view name) {
  if (name == name_of_limit) return TestGrid::extrapolated();
  int cells = 0;
  const auto* const end_of_name = name.data() + name.size();
  const auto [end, error] = std::from_chars(name.data(), end_of_name, cells);
  const bool is_grid = error == std::errc{} && end == end_of_name && cells > 0;
  return is_grid ? std::optional(TestGrid(cells)) : std::nullopt;
}

bool is_preferred(const TestId& one, const TestId& other) {
  const auto rank = [](const TestId& id) { return std::pair(id.method == Method::quasistatic, id.grid); };
  return rank(one) > rank(other);
}

}  // namespace breccia
