#include "quasistatic/solvers/substructuring/block_stiffness.hpp"

#include <gtest/gtest.h>

#include "quasistatic/random_blocks.hpp"
#include "test_names.hpp"

namespace breccia::quasistatic {
namespace {

constexpr Block shape = {0, 0, 5, 4};
constexpr Eigen::Index inside = 2 * 4 * 3, boundary = 2 * 18;

double difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

class RandomBlock : public testing::TestWithParam<double> {
 protected:
  std::vector<CellShape<2>::Stiffness> cells_ = test::random_cells(shape.columns * shape.rows, GetParam(), 3);
  BlockStiffness stiffness_{test::block_of(shape, cells_), 1.0};
  Eigen::MatrixXd dense_ = test::dense_stiffness(shape, cells_);
  Eigen::MatrixXd a_ii_ = dense_.topLeftCorner(inside, inside);
  Eigen::MatrixXd a_ib_ = dense_.topRightCorner(inside, boundary);
};

TEST_P(RandomBlock, IsCondensedToTheSchurComplement) {
  ASSERT_EQ(stiffness_.inside(), inside);
  const Eigen::MatrixXd schur =
      dense_.bottomRightCorner(boundary, boundary) - a_ib_.transpose() * a_ii_.fullPivLu().solve(a_ib_);
  EXPECT_LT(difference(stiffness_.condensed(), schur), 1e-12);
}

TEST_P(RandomBlock, CarriesForcesInsideToItsBoundary) {
  const Eigen::VectorXd forces = Eigen::VectorXd::LinSpaced(inside, -1.0, 2.0);
  EXPECT_LT(difference(stiffness_.carried_by_boundary(forces), a_ib_.transpose() * a_ii_.fullPivLu().solve(forces)),
            1e-10);
}

TEST_P(RandomBlock, IsInBalanceInsideUnderForcesAndDisplacementsOfItsBoundary) {
  const Eigen::VectorXd forces = Eigen::VectorXd::LinSpaced(inside, -1.0, 2.0);
  const Eigen::VectorXd of_boundary = Eigen::VectorXd::LinSpaced(boundary, 3.0, -2.0);
  const Eigen::VectorXd found = stiffness_.displacement_inside(forces, of_boundary);
  const Eigen::VectorXd residual = forces - a_ii_ * found - a_ib_ * of_boundary;
  EXPECT_LT(residual.norm(), 1e-12 * a_ii_.norm() * found.norm());
}

TEST_P(RandomBlock, ResistsNoRigidMotionOfItsBoundary) {
  const auto nodes = boundary_nodes(shape);
  Eigen::MatrixXd motions(boundary, 3);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(2 * i);
    motions.row(row) << 1.0, 0.0, -nodes[i].y;
    motions.row(row + 1) << 0.0, 1.0, nodes[i].x;
  }
  const auto condensed = stiffness_.condensed();
  EXPECT_LT((condensed * motions).cwiseAbs().maxCoeff(), 1e-11 * condensed.cwiseAbs().maxCoeff());
}

INSTANTIATE_TEST_SUITE_P(Contrasts, RandomBlock, testing::Values(1.0, 1e2, 1e5), breccia::test::by_value);

TEST(BlockStiffness, HeldUnknownsAreCoupledToNothing) {
  const auto cells = test::random_cells(shape.columns * shape.rows, 10.0, 4);
  auto kind = test::block_of(shape, cells);
  const std::vector<std::size_t> held = {0, 9, 35};
  Eigen::MatrixXd expected = BlockStiffness(kind, 7.0).condensed();
  for (const auto h : held) {
    kind.held[h] = true;
    const auto i = static_cast<Eigen::Index>(h);
    expected.row(i).setZero();
    expected.col(i).setZero();
    expected(i, i) = 7.0;
  }
  EXPECT_LT(difference(BlockStiffness(kind, 7.0).condensed(), expected), 1e-13);
}

TEST(BlockStiffness, OfARowOfCellsHasNothingToCondense) {
  const Block row = {0, 0, 3, 1};
  const auto cells = test::random_cells(3, 10.0, 5);
  const BlockStiffness stiffness(test::block_of(row, cells), 1.0);
  EXPECT_EQ(stiffness.inside(), 0);
  EXPECT_EQ(stiffness.condensed(), test::dense_stiffness(row, cells));
  EXPECT_EQ(stiffness.carried_by_boundary(Eigen::VectorXd(0)), Eigen::VectorXd::Zero(16));
}

}  // namespace
}  // namespace breccia::quasistatic
