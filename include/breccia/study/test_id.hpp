#pragma once

#include <compare>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "breccia/discretisation/boundary.hpp"
#include "breccia/discretisation/load.hpp"
#include "breccia/study/tests.hpp"

namespace breccia {

/// The grid that a result stands on: so many cells per side, or the limit of vanishing cells, which is extrapolated
/// from several grids. Grids rise with their cells; the limit is above all of them.
class TestGrid {
 public:
  /// A grid of one cell or more per side.
  constexpr explicit TestGrid(int cells) : cells_(cells) {}
  static constexpr TestGrid extrapolated() { return TestGrid(std::numeric_limits<int>::max()); }

  [[nodiscard]] constexpr bool is_extrapolated() const { return cells_ == std::numeric_limits<int>::max(); }
  /// Cells per side; nothing of the limit.
  [[nodiscard]] constexpr std::optional<int> cells() const {
    return is_extrapolated() ? std::nullopt : std::optional(cells_);
  }

  friend constexpr auto operator<=>(const TestGrid&, const TestGrid&) = default;

 private:
  int cells_;
};

/// A grid in tables: "150", or "extrapolated".
std::string name_of(TestGrid grid);

/// The grid with such a name; nothing for any other text.
std::optional<TestGrid> grid_named(std::string_view name);

/// Which test of a stage: everything that tells two of them apart.
struct TestId {
  Load load = Load::shear;
  Boundary boundary = Boundary::displacement;
  Method method = Method::quasistatic;
  TestGrid grid = TestGrid::extrapolated();

  friend bool operator==(const TestId&, const TestId&) = default;
};

/// Does a test stand for the other one where a single one is shown? Of tests that differ in their method or grid alone
/// the quasi-static ones come before the dynamic ones, and of each method the limit of vanishing cells before the
/// finest grid.
bool is_preferred(const TestId& one, const TestId& other);

}  // namespace breccia
