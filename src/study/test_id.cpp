#include "breccia/study/test_id.hpp"

#include <charconv>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia {
namespace {

constexpr std::string_view name_of_limit = "extrapolated";
constexpr std::string_view name_of_films = "films";

}  // namespace

TestGrid::TestGrid(int cells) : TestGrid(Kind::cells, cells) {
  if (cells < 1) throw InputError(fmt::format("a grid of {} cells: expected one cell or more per side", cells));
}

std::string name_of(TestGrid grid) {
  if (grid.is_films()) return std::string(name_of_films);
  const auto cells = grid.cells();
  return cells ? std::to_string(*cells) : std::string(name_of_limit);
}

std::optional<TestGrid> grid_named(std::string_view name) {
  if (name == name_of_limit) return TestGrid::extrapolated();
  if (name == name_of_films) return TestGrid::films();
  int cells = 0;
  const auto* const end_of_name = name.data() + name.size();
  const auto [end, error] = std::from_chars(name.data(), end_of_name, cells);
  const bool is_grid = error == std::errc{} && end == end_of_name && cells > 0;
  return is_grid ? std::optional(TestGrid(cells)) : std::nullopt;
}

std::string words_of(TestGrid grid) {
  return grid.is_films() ? name_of(grid) : name_of(grid) + " cells";
}

std::string calculation_of(const TestId& test) {
  const auto boundary_and_grid = fmt::format("{}, {}", name_of(test.boundary), words_of(test.grid));
  if (test.method == Method::quasistatic) return boundary_and_grid + ", quasi-static";
  return fmt::format("{}, {}, dynamic", name_of(test.load), boundary_and_grid);
}

bool is_preferred(const TestId& one, const TestId& other) {
  const auto rank = [](const TestId& id) { return std::pair(id.method == Method::quasistatic, id.grid); };
  return rank(one) > rank(other);
}

}  // namespace breccia
