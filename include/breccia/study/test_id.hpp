#pragma once

#include <compare>
#include <optional>
#include <string>
#include <string_view>

#include "breccia/discretisation/boundary.hpp"
#include "breccia/study/tests.hpp"

namespace breccia {

/// The grid of a result: a number of cells per side, or the limit of vanishing cells, which is extrapolated from
/// several grids; or none, where the result is that of the model of grains and films. Grids are ordered by their cells;
/// the limit is greater than all of them, and the model of films less.
class TestGrid {
 public:
  /// A grid of so many cells per side. Throws InputError where they are fewer than one.
  explicit TestGrid(int cells);
  static TestGrid films() { return {Kind::films, 0}; }
  static TestGrid extrapolated() { return {Kind::limit, 0}; }

  [[nodiscard]] bool is_films() const { return kind_ == Kind::films; }
  [[nodiscard]] bool is_extrapolated() const { return kind_ == Kind::limit; }
  /// Cells per side; nothing for the limit and for films.
  [[nodiscard]] std::optional<int> cells() const { return kind_ == Kind::cells ? std::optional(cells_) : std::nullopt; }

  // NOLINTNEXTLINE(modernize-use-nullptr): the check takes the 0 with which the default compares for a null pointer
  friend auto operator<=>(const TestGrid&, const TestGrid&) = default;

 private:
  enum class Kind { films, cells, limit };
  TestGrid(Kind kind, int cells) : kind_(kind), cells_(cells) {}

  Kind kind_ = Kind::cells;
  int cells_;
};

/// The name of a grid in tables: "150", "extrapolated" or "films".
std::string name_of(TestGrid grid);

/// The name of a grid in a sentence: "150 cells", "extrapolated cells", "films".
std::string words_of(TestGrid grid);

/// The grid with a name as name_of() returns it; nothing for any other text.
std::optional<TestGrid> grid_named(std::string_view name);

/// Identifies a test of a stage by its load, boundary condition, method and grid.
struct TestId {
  TestLoad load = Load::shear;
  Boundary boundary = Boundary::displacement;
  Method method = Method::quasistatic;
  TestGrid grid;

  friend bool operator==(const TestId&, const TestId&) = default;
};

/// The calculation that a test is part of, in words: "shear, displacement, 150 cells, dynamic". The quasi-static method
/// computes all loads together, so that the names of its calculations have no load: "displacement, 150 cells,
/// quasi-static", "displacement, films, quasi-static".
std::string calculation_of(const TestId& test);

/// Whether one test is preferred to another that differs from it only in method or grid: quasi-static tests are
/// preferred to dynamic ones, and, for each method, the limit of vanishing cells to the finest grid.
bool is_preferred(const TestId& one, const TestId& other);

}  // namespace breccia
