#include "quasistatic/solvers/substructuring/bddc_preconditioner.hpp"

#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "parallel/session.hpp"
#include "quasistatic/composites.hpp"
#include "quasistatic/operator/elastic_operator.hpp"
#include "test_names.hpp"

namespace breccia::quasistatic {
namespace {

/// Moduli by material: a stiff solid, and a nearly incompressible one whose shear modulus is lower by a contrast.
std::vector<Moduli> moduli_with(double contrast) {
  return {{.bulk = 13.4, .shear = 5.84}, {.bulk = 3.6, .shear = 5.84 / contrast}};
}

/// A discretisation whose points have one of two materials at random.
Discretisation<2> random_points(int cells, std::uint64_t seed) {
  Discretisation<2> discretisation(Grid<2>{{cells, cells}, 1.0});
  std::mt19937_64 random(seed);
  discretisation.paint([&](const Vector<2>&) { return random() % 2 == 0; }, 1);
  return discretisation;
}

/// The condensed stiffness S between blocks and the preconditioner M^-1 as dense matrices, without held unknowns.
struct Dense {
  Eigen::MatrixXd stiffness, preconditioner;

  /// Ascending eigenvalues of M^-1 S.
  [[nodiscard]] Eigen::VectorXd spectrum() const {
    const Eigen::LLT<Eigen::MatrixXd> factor(stiffness);
    const Eigen::MatrixXd lower = factor.matrixL();
    const Eigen::MatrixXd symmetric = 0.5 * (preconditioner + preconditioner.transpose());
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(lower.transpose() * symmetric * lower).eigenvalues();
  }
};

Dense dense(const Discretisation<2>& discretisation, Boundary boundary, double contrast) {
  const auto moduli = moduli_with(contrast);
  const ElasticOperator<2> elastic_operator(discretisation, Volumetric::averaged, boundary);
  const Substructures blocks(elastic_operator);
  const auto cells = elastic_operator.kinds().stiffnesses(moduli);
  constexpr double stiffness_of_held = 10.0;
  std::vector<PackedSymmetric<double>> condensed;
  for (std::size_t kind = 0; kind < blocks.blocks_by_kind().size(); ++kind) {
    condensed.emplace_back(
        BlockStiffness(blocks.block_kind(static_cast<int>(kind), cells, {}), stiffness_of_held).condensed());
  }
  BddcPreconditioner preconditioner(blocks, condensed, stiffness_of_held, 1);

  const auto all = static_cast<Eigen::Index>(blocks.grid().unknowns());
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(all, all);
  for (int b = 0; b < blocks.grid().blocks(); ++b) {
    const int* unknowns = blocks.unknowns_of(b);
    const auto of_block = condensed[static_cast<std::size_t>(blocks.kind_of(b))].full();
    for (Eigen::Index i = 0; i < of_block.rows(); ++i) {
      for (Eigen::Index j = 0; j < of_block.cols(); ++j) {
        if (unknowns[i] >= 0 && unknowns[j] >= 0) stiffness(unknowns[i], unknowns[j]) += of_block(i, j);
      }
    }
  }
  std::vector<Eigen::Index> free;
  Eigen::MatrixXd inverse(all, all);
  std::vector<double> unit(static_cast<std::size_t>(all)), result(unit.size());
  for (Eigen::Index u = 0; u < all; ++u) {
    if (stiffness(u, u) == 0.0) continue;
    free.push_back(u);
    unit[static_cast<std::size_t>(u)] = 1.0;
    preconditioner.apply(unit, result);
    unit[static_cast<std::size_t>(u)] = 0.0;
    inverse.col(u) = Eigen::Map<const Eigen::VectorXd>(result.data(), all);
  }
  return {stiffness(free, free), inverse(free, free)};
}

class Bddc : public testing::TestWithParam<Boundary> {
 protected:
  void SetUp() override { parallel::start(); }
};

TEST_P(Bddc, IsSymmetricAndPositiveDefinite) {
  for (const double contrast : {1.0, 1e5}) {
    const auto [stiffness, preconditioner] = dense(random_points(17, 1), GetParam(), contrast);
    EXPECT_LT((preconditioner - preconditioner.transpose()).norm(), 1e-5 * preconditioner.norm()) << contrast;
    EXPECT_EQ(Eigen::LLT<Eigen::MatrixXd>(preconditioner).info(), Eigen::Success) << contrast;
  }
}

TEST_P(Bddc, HasASmallConditionNumberForAnyContrastAndSize) {
  for (const int cells : {16, 24, 33}) {
    for (const double contrast : {1.0, 1e2, 1e5}) {
      const auto spectrum = dense(random_points(cells, 2), GetParam(), contrast).spectrum();
      // Balancing by constraints has no eigenvalue below 1, and none beyond a multiple of the tolerance of 8.
      const double least = spectrum[0], largest = spectrum[spectrum.size() - 1];
      EXPECT_GT(least, 0.999) << cells << " cells, contrast " << contrast;
      EXPECT_LT(largest, 16.0) << cells << " cells, contrast " << contrast;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Boundaries, Bddc, testing::ValuesIn(breccia::test::boundaries), breccia::test::by_words);

TEST(BddcOfOneBlock, IsTheInverse) {
  parallel::start();
  for (const double contrast : {1.0, 1e2}) {
    const auto [stiffness, preconditioner] = dense(random_points(7, 3), Boundary::traction, contrast);
    const Eigen::MatrixXd product = preconditioner * stiffness;
    EXPECT_LT((product - Eigen::MatrixXd::Identity(product.rows(), product.cols())).norm(), 1e-3) << contrast;
  }
}

}  // namespace
}  // namespace breccia::quasistatic
