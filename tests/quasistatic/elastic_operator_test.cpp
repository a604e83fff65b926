#include "operator/elastic_operator.hpp"

#include <set>

#include <gtest/gtest.h>

namespace breccia::quasistatic {
namespace {

/// Every cell has materials of its own.
Discretisation of_different_cells(int side, int materials) {
  const Grid grid = {side, side, 1.0};
  Discretisation discretisation(grid);
  for (int material = 1; material < materials; ++material) {
    discretisation.paint(
        [&](const Vector<2>& place) {
          const int column = static_cast<int>(place[0]), row = static_cast<int>(place[1]);
          const bool right = place[0] - column > 0.5, upper = place[1] - row > 0.5;
          auto number = grid.cell_index(column, row);
          for (int point = 0; point < (right ? 1 : 0) + (upper ? 2 : 0); ++point) {
            number /= static_cast<std::size_t>(materials);
          }
          return static_cast<int>(number % static_cast<std::size_t>(materials)) == material;
        },
        static_cast<MaterialIndex>(material));
  }
  return discretisation;
}

TEST(ElasticOperator, TellsMoreThan65536KindsOfCellsApart) {
  constexpr int side = 257, materials = 17;
  const ElasticOperator elastic_operator(of_different_cells(side, materials), Volumetric::averaged,
                                         Boundary::displacement);
  std::set<std::size_t> kinds;
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) kinds.insert(elastic_operator.kind_of_cell(column, row));
  }
  EXPECT_EQ(kinds.size(), static_cast<std::size_t>(side) * side);
}

}  // namespace
}  // namespace breccia::quasistatic
