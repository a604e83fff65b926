#include "quasistatic/solvers/substructuring/packed_symmetric.hpp"

#include <gtest/gtest.h>

namespace breccia::quasistatic {
namespace {

const Eigen::MatrixXd matrix{{4.0, 1.0, -2.0}, {1.0, 5.0, 0.5}, {-2.0, 0.5, 6.0}};

TEST(PackedSymmetric, GivesTheWholeMatrixBack) {
  EXPECT_EQ(PackedSymmetric<double>(matrix).size(), 3);
  EXPECT_EQ(PackedSymmetric<double>(matrix).full(), matrix);
  EXPECT_EQ(PackedSymmetric<float>(matrix).full(), matrix);
}

TEST(PackedSymmetric, ReadsTheLowerTriangleAlone) {
  Eigen::MatrixXd other = matrix;
  other(0, 2) = 17.0;
  EXPECT_EQ(PackedSymmetric<double>(other).full(), matrix);
}

TEST(PackedSymmetric, MultipliesAVectorWhateverTheResultHeld) {
  const Eigen::VectorXd x{{1.0, -2.0, 3.0}};
  Eigen::VectorXd y = Eigen::VectorXd::Constant(7, 1e3);
  PackedSymmetric<double>(matrix).multiply(x, y);
  EXPECT_EQ(y, (Eigen::VectorXd{{-4.0, -7.5, 15.0}}));
  Eigen::VectorXf z;
  PackedSymmetric<float>(matrix).multiply(x.cast<float>(), z);
  EXPECT_EQ(z, (Eigen::VectorXf{{-4.0F, -7.5F, 15.0F}}));
}

TEST(PackedSymmetric, MayBeEmpty) {
  Eigen::VectorXd y = Eigen::VectorXd::Ones(2);
  PackedSymmetric<double>().multiply(Eigen::VectorXd(0), y);
  EXPECT_EQ(y.size(), 0);
  EXPECT_EQ(PackedSymmetric<double>().full().size(), 0);
}

}  // namespace
}  // namespace breccia::quasistatic
