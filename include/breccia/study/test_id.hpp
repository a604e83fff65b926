#pragma once

#include <compare>
#include <optional>
#include <string>
#include <string_view>

#include "breccia/discretisation/boundary.hpp"
#include "breccia/discretisation/load.hpp"
#include "breccia/study/tests.hpp"

namespace breccia {

/// The grid of a result: a number of cells per side, or the limit of vanishing cells, which is extrapolated from
/// several grids. Grids are ordered by their cells; the limit is greater than all of them.
class TestGrid {
 public:
  /// A grid of so many cells per side. Throws InputError where they are fewer than one.
  explicit TestGrid(int cells);
  static TestGrid extrapolated() { return {}; }

  [[nodiscard]] bool is_extrapolated() const { return !cells_; }
  /// Cells per side; nothing for the limit.
  [[nodiscard]] std::optional<int> cells() const { return cells_; }

  friend bool operator==(const TestGrid&, const TestGrid&) = default;
  friend std::strong_ordering operator<=>(const TestGrid& one, const TestGrid& other);

 private:
  TestGrid() = default;

  std::optional<int> cells_;
};

/// The name of a grid in tables: "150", or "extrapolated".
std::string name_of(TestGrid grid);

/// The grid with such a name; nothing for any other text.
std::optional<TestGrid> grid_named(std::string_view name);

/// Identifies a test of a stage by its load, boundary condition, method and grid.
struct TestId {
  Load load = Load::shear;
  Boundary boundary = Boundary::displacement;
  Method method = Method::quasistatic;
  TestGrid grid;

  friend bool operator==(const TestId&, const TestId&) = default;
};

/// The calculation that a test is part of, in words: "shear, upper bound, 150 cells, dynamic". The quasi-static method
/// computes all loads together, so that its calculations have none: "upper bound, 150 cells, quasi-static".
std::string calculation_of(const TestId& test);

/// Whether one test is preferred to another that differs from it only in method or grid: quasi-static tests are
/// preferred to dynamic ones, and, for each method, the limit of vanishing cells to the finest grid.
bool is_preferred(const TestId& one, const TestId& other);

}  // namespace breccia
