#include "quasistatic/solvers/substructuring/substructures.hpp"

#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace breccia::quasistatic {
namespace {

TEST(Substructures, OfAHomogeneousBoxDifferByTheSidesThatAreHeld) {
  // 5 x 5 blocks of 8 x 8 cells: four corners, four sides, and those inside.
  const ElasticOperator<2> elastic_operator(Discretisation<2>(Grid<2>{{40, 40}, 1.0}), Volumetric::averaged,
                                            Boundary::displacement);
  const Substructures blocks(elastic_operator);
  EXPECT_EQ(blocks.grid().blocks(), 25);
  EXPECT_EQ(blocks.blocks_by_kind().size(), 9U);
  EXPECT_EQ(blocks.blocks_by_kind()[static_cast<std::size_t>(blocks.kind_of(12))].size(), 9U);
  // An inner block whose neighbours are all inner blocks is of another kind than one with a neighbour at a side.
  EXPECT_EQ(blocks.blocks_with_neighbours().size(), 25U);
  std::set<int> held;
  for (int b = 0; b < 25; ++b) {
    for (int i = 0; i < blocks.unknowns_on_boundary(b); ++i) {
      if (blocks.unknowns_of(b)[i] < 0) held.insert(b);
    }
  }
  EXPECT_EQ(held.size(), 16U);
}

TEST(Substructures, OfOneKindHaveTheSameCellsAndNeighbours) {
  // Stripes of two blocks' width repeat across a periodic box of eight blocks.
  Discretisation<2> discretisation(Grid<2>{{64, 32}, 1.0});
  discretisation.paint([](const Vector<2>& position) { return static_cast<int>(position[0]) % 16 < 5; }, 1);
  const ElasticOperator<2> elastic_operator(discretisation, Volumetric::averaged, Boundary::periodic);
  const Substructures blocks(elastic_operator);
  const std::vector<Moduli> moduli = {{.bulk = 2.0, .shear = 1.0}, {.bulk = 3.0, .shear = 4.0}};
  const auto cells = elastic_operator.kinds().stiffnesses(moduli);
  ASSERT_EQ(blocks.grid().blocks(), 32);
  for (int b = 0; b < 32; ++b) {
    const auto kind = blocks.block_kind(blocks.kind_of(b), cells, {});
    const auto block = blocks.grid().block(b);
    ASSERT_EQ(kind.cells.size(), 64U);
    for (int cell = 0; cell < 64; ++cell) {
      const int column = block.first_column + cell % 8, row = block.first_row + cell / 8;
      EXPECT_EQ(kind.cells[static_cast<std::size_t>(cell)], &cells[elastic_operator.kinds().of({column, row})]);
    }
    const auto& with_neighbours = blocks.blocks_with_neighbours()[static_cast<std::size_t>(blocks.neighbourhood_of(b))];
    EXPECT_EQ(with_neighbours.kind, blocks.kind_of(b));
    const auto edges = blocks.grid().edges_of(b);
    for (std::size_t side = 0; side < 4; ++side) {
      EXPECT_EQ(with_neighbours.edges.at(side), blocks.edge_kind_of(edges.at(side)));
    }
  }
  // Two kinds by their cells, and four more around the node that is held.
  EXPECT_EQ(blocks.blocks_by_kind().size(), 6U);
}

}  // namespace
}  // namespace breccia::quasistatic
