#include "quasistatic/solvers/substructuring/edge_averages.hpp"

#include <gtest/gtest.h>

#include "quasistatic/random_blocks.hpp"
#include "test_names.hpp"

namespace breccia::quasistatic {
namespace {

constexpr double tolerance = 8.0;
constexpr Eigen::Index vertex_unknowns = 8;

/// Two blocks of 6 x 5 and 6 x 4 cells, the first below the second.
struct Pair {
  Eigen::MatrixXd lower, upper;
  Block lower_shape = {0, 0, 6, 5}, upper_shape = {0, 5, 6, 4};

  [[nodiscard]] EdgeAverage average() const {
    return average_at_edge(stiffness_at_edge({&lower, lower_shape, top}),
                           stiffness_at_edge({&upper, upper_shape, bottom}), tolerance);
  }
  [[nodiscard]] SideRange lower_edge() const { return side_range(lower_shape, top); }
  [[nodiscard]] SideRange upper_edge() const { return side_range(upper_shape, bottom); }
  [[nodiscard]] Eigen::MatrixXd s1() const {
    const auto [begin, size] = lower_edge();
    return lower.block(begin, begin, size, size);
  }
  [[nodiscard]] Eigen::MatrixXd s2() const {
    const auto [begin, size] = upper_edge();
    return upper.block(begin, begin, size, size);
  }
};

Eigen::MatrixXd condensed(const Block& shape, const std::vector<CellShape<2>::Stiffness>& cells) {
  return BlockStiffness(test::block_of(shape, cells), 1.0).condensed();
}

Pair random_pair(double contrast, std::uint64_t seed) {
  Pair pair;
  pair.lower = condensed(pair.lower_shape, test::random_cells(30, contrast, seed));
  pair.upper = condensed(pair.upper_shape, test::random_cells(24, contrast, seed + 100));
  return pair;
}

/// Least energy of the two blocks for a jump at their edge, with no jump at its ends: all displacements of both blocks
/// are unknowns, and Lagrange multipliers impose the jumps.
Eigen::MatrixXd least_energy_of_jumps(const Pair& pair) {
  const Eigen::Index n1 = pair.lower.rows(), n2 = pair.upper.rows(), size = pair.lower_edge().size, jumps = size + 4;
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n1 + n2 + jumps, n1 + n2 + jumps);
  system.topLeftCorner(n1, n1) = pair.lower;
  system.block(n1, n1, n2, n2) = pair.upper;
  const auto impose = [&](Eigen::Index jump, Eigen::Index of_lower, Eigen::Index of_upper) {
    for (const auto& [index, sign] : {std::pair(of_lower, 1.0), std::pair(n1 + of_upper, -1.0)}) {
      system(n1 + n2 + jump, index) = system(index, n1 + n2 + jump) = sign;
    }
  };
  for (Eigen::Index i = 0; i < size; ++i) impose(i, pair.lower_edge().begin + i, pair.upper_edge().begin + i);
  for (Eigen::Index i = 0; i < 4; ++i) impose(size + i, n1 - 4 + i, n2 - vertex_unknowns + i);
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(system.rows(), size);
  right.middleRows(n1 + n2, size).setIdentity();
  // The multipliers are minus the forces that hold the jumps. Rigid motions of both blocks together leave them alone.
  return -system.completeOrthogonalDecomposition().solve(right).middleRows(n1 + n2, size);
}

/// Energy of a jump when it is averaged, from the parallel sum of the stiffnesses.
Eigen::MatrixXd averaged_energy_of_jumps(const Pair& pair) {
  return pair.s2() * (pair.s1() + pair.s2()).fullPivLu().solve(pair.s1());
}

/// The factors by which averaging multiplies the energy of jumps, mode by mode, rising.
Eigen::VectorXd ratios_of(const Eigen::MatrixXd& averaged, const Eigen::MatrixXd& least) {
  return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(averaged, least).eigenvalues();
}

/// Constraints must leave no jump that averaging would multiply by more than the tolerance, and none is superfluous.
void expect_sufficient_constraints(const Pair& pair) {
  const auto constraints = pair.average().constraints;
  const auto averaged = averaged_energy_of_jumps(pair), least = least_energy_of_jumps(pair);
  EXPECT_EQ((ratios_of(averaged, least).array() > tolerance).count(), constraints.cols());
  Eigen::MatrixXd allowed = Eigen::MatrixXd::Identity(averaged.rows(), averaged.rows());  // jumps d with q'd = 0
  if (constraints.cols() > 0) {
    const Eigen::MatrixXd all = constraints.householderQr().householderQ();
    allowed = all.rightCols(averaged.rows() - constraints.cols());
  }
  const auto left = ratios_of(allowed.transpose() * averaged * allowed, allowed.transpose() * least * allowed);
  EXPECT_LT(left.maxCoeff(), tolerance * (1.0 + 1e-5));
}

class RandomEdge : public testing::TestWithParam<double> {};

TEST_P(RandomEdge, WeighsDisplacementsByTheStiffnessesOfTheBlocks) {
  const auto pair = random_pair(GetParam(), 1);
  const Eigen::MatrixXd expected = (pair.s1() + pair.s2()).fullPivLu().solve(pair.s1());
  EXPECT_LT((pair.average().lower_weight - expected).norm(), 1e-9 * expected.norm());
}

TEST_P(RandomEdge, LeavesNoJumpWhoseEnergyAveragingMultipliesByMoreThanTheTolerance) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) expect_sufficient_constraints(random_pair(GetParam(), seed));
}

INSTANTIATE_TEST_SUITE_P(Contrasts, RandomEdge, testing::Values(1.0, 1e2, 1e4), breccia::test::by_value);

/// Stiffness of a cell of one isotropic material.
CellShape<2>::Stiffness uniform_cell(double bulk, double shear) {
  CellShape<2>::PointModuli moduli{};
  moduli.fill({.bulk = bulk, .shear = shear});
  return CellShape<2>::stiffness(moduli, Volumetric::averaged);
}

TEST(EdgeAverage, OfMirroredBlocksIsTheMean) {
  const Block shape = {0, 0, 6, 6};
  const auto stiffness = condensed(shape, std::vector(36, uniform_cell(2.0, 1.0)));
  const auto weight = average_at_edge(stiffness_at_edge({&stiffness, shape, top}),
                                      stiffness_at_edge({&stiffness, shape, bottom}), tolerance)
                          .lower_weight;
  // The upper block is the mirror image of the lower one, which changes the sign of y displacements. So does its
  // weight.
  Eigen::VectorXd mirror(10);
  for (Eigen::Index i = 0; i < 10; ++i) mirror[i] = i % 2 == 0 ? 1.0 : -1.0;
  const Eigen::MatrixXd upper_weight = mirror.asDiagonal() * weight * mirror.asDiagonal();
  EXPECT_LT((weight + upper_weight - Eigen::MatrixXd::Identity(10, 10)).norm(), 1e-12);
}

TEST(EdgeAverage, FollowsTheStifferBlock) {
  Pair pair;
  const auto soft = uniform_cell(2.0, 1.0);
  pair.lower = condensed(pair.lower_shape, std::vector<CellShape<2>::Stiffness>(30, 1e6 * soft));
  pair.upper = condensed(pair.upper_shape, std::vector<CellShape<2>::Stiffness>(24, soft));
  EXPECT_LT((pair.average().lower_weight - Eigen::MatrixXd::Identity(10, 10)).norm(), 1e-5);
}

// With the other sides of both blocks held, two modes of the edge change the volume of cells whatever the nodes inside
// do, one for each pressure field that cells of constant pressure cannot balance: the uniform one (flow through the
// edge, the sum of all normal displacements) and the checkerboard (the alternating sum of the tangential ones).
TEST(EdgeAverage, ConstrainsTheFlowThroughTheEdgeOfNearlyIncompressibleBlocks) {
  const auto pair_of = [](double bulk) {
    const auto cell = uniform_cell(bulk, 1.0);
    Pair pair;
    pair.lower = condensed(pair.lower_shape, std::vector(30, cell));
    pair.upper = condensed(pair.upper_shape, std::vector(24, cell));
    return pair;
  };
  EXPECT_EQ(pair_of(1.0).average().constraints.cols(), 0);

  const auto incompressible = pair_of(1e5);
  expect_sufficient_constraints(incompressible);
  const auto constraints = incompressible.average().constraints;
  ASSERT_EQ(constraints.cols(), 2);
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(10, 2);
  for (Eigen::Index node = 0; node < 5; ++node) {
    expected(2 * node + 1, 0) = 1.0;
    expected(2 * node, 1) = node % 2 == 0 ? 1.0 : -1.0;
  }
  const Eigen::MatrixXd left = expected - constraints * constraints.colPivHouseholderQr().solve(expected);
  EXPECT_LT(left.norm(), 1e-3 * expected.norm());
}

TEST(EdgeAverage, OfBlocksOfOneCellIsEmpty) {
  const Block cell = {0, 0, 1, 1};
  const auto stiffness = condensed(cell, test::random_cells(1, 1.0, 1));
  const auto average = average_at_edge(stiffness_at_edge({&stiffness, cell, right}),
                                       stiffness_at_edge({&stiffness, cell, left}), tolerance);
  EXPECT_EQ(average.lower_weight.size(), 0);
  EXPECT_EQ(average.constraints.size(), 0);
}

}  // namespace
}  // namespace breccia::quasistatic
