#include "quasistatic/solvers/substructuring/coarse_solver.hpp"

#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "parallel/session.hpp"

namespace breccia::quasistatic {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

class Coarse : public testing::Test {
 protected:
  void SetUp() override { parallel::start(); }

  /// A solver for the matrix of two unknowns with `coupling` off the diagonal and 1 on it.
  static CoarseSolver solver(double coupling) {
    const Eigen::MatrixXd matrix{{1.0, coupling}, {coupling, 1.0}};
    return {2, 2, SharedValues(), {{{0, 1}, &matrix}}, 1.0};
  }
};

TEST_F(Coarse, SolvesASmallSystem) {
  std::vector<double> solution(2);
  solver(0.5).solve({1.0, 0.0}, solution);
  EXPECT_NEAR(solution[0], 4.0 / 3.0, 1e-15);
  EXPECT_NEAR(solution[1], -2.0 / 3.0, 1e-15);
}

TEST_F(Coarse, CountsItsUnknowns) {
  EXPECT_EQ(solver(0.5).unknowns(), 2);
}

TEST_F(Coarse, SaysThatItCannotBeFactorised) {
  EXPECT_THAT([] { solver(1.0); }, ThrowsMessage<NumericalError>(
                                       AllOf(HasSubstr("cannot be factorised"), HasSubstr("memory may have run out"))));
}

}  // namespace
}  // namespace breccia::quasistatic
