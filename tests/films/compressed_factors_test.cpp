#include "films/solver/compressed_factors.hpp"

#include <array>
#include <limits>

#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/microstructure/random_sites.hpp"

#include "films/film_composite.hpp"
#include "films/grains_and_films.hpp"
#include "films/grid_matrix.hpp"
#include "films/solver/minimal_residuals.hpp"
#include "films/solver/symmetric_factors.hpp"

namespace breccia::films {
namespace {

Eigen::MatrixXd unsymmetric_matrix() {
  Eigen::MatrixXd matrix(4, 4);
  matrix << 2.0, 1.0, 0.0, 0.5, -1.0, 3.0, 0.2, 0.0, 0.0, 0.4, -1.0, 2.0, 0.3, 0.0, 1.0, 4.0;
  return matrix;
}

TEST(MinimalResiduals, SolveInAsManyStepsAsThereAreRows) {
  const auto matrix = unsymmetric_matrix();
  const Eigen::VectorXd solution = Eigen::VectorXd::LinSpaced(4, 1.0, 4.0), right_side = matrix * solution;
  const auto multiply = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd { return matrix * x; };
  const auto none = [](const Eigen::VectorXd& x) { return x; };
  const auto found = minimal_residuals(multiply, none, right_side, 1e-12, 10);
  EXPECT_EQ(found.iterations, 4);
  EXPECT_LT((found.solution - solution).norm(), 1e-12);
  const auto early = minimal_residuals(multiply, none, right_side, 1e-12, 2);
  EXPECT_EQ(early.iterations, 2);
  EXPECT_NEAR(early.residual, (right_side - matrix * early.solution).norm() / right_side.norm(), 1e-14);
}

TEST(MinimalResiduals, SolveInOneStepWithTheInverse) {
  const auto matrix = unsymmetric_matrix();
  const Eigen::MatrixXd inverse = matrix.inverse();
  const auto multiply = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd { return matrix * x; };
  const auto precondition = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd { return inverse * x; };
  const auto found = minimal_residuals(multiply, precondition, Eigen::VectorXd::Ones(4), 1e-12, 10);
  EXPECT_EQ(found.iterations, 1);
  EXPECT_LT((matrix * found.solution - Eigen::VectorXd::Ones(4)).norm(), 1e-12);
  const auto zero = minimal_residuals(multiply, precondition, Eigen::VectorXd::Zero(4), 1e-12, 10);
  EXPECT_EQ(zero.iterations, 0);
  EXPECT_EQ(zero.solution, Eigen::VectorXd::Zero(4));
}

TEST(CompressedFactors, SolveForOneMatrixAfterTheOther) {
  CompressedFactors factors;
  for (const double stiffness : {1.0, 1e3, 1e6}) {
    const auto matrix = test::grid_matrix(stiffness);
    factors.factorise([&] { return matrix; });
    const auto load = test::right_side(matrix);
    const auto solution = factors.solve(load);
    EXPECT_LT((matrix.selfadjointView<Eigen::Lower>() * solution - load).norm(), 1e-7 * load.norm());
    EXPECT_LT(factors.residual(), 1e-9);
    EXPECT_GT(factors.iterations(), 0);
  }
}

/// The forces of the uniform strain of a load, with zeros for the pressures.
Eigen::VectorXd forces_of(const FilmComposite<3>& composite, const std::array<double, 2>& parameters, Load load) {
  const auto& of_films = composite.film_operator();
  auto prescribed = composite.zero();
  prescribed.set_macroscopic(1.0);
  Eigen::VectorXd right_side = Eigen::VectorXd::Zero(of_films.unknowns() + of_films.pressures());
  right_side.head(of_films.unknowns()) = composite.forces(parameters, load, prescribed).unknowns();
  return right_side;
}

// Grains and films from a binder as stiff as a grain to one that is ten thousand times softer: the energy is that of
// full factors to nine digits.
TEST(CompressedFactors, OfFilmsInSpaceAreAsGoodAsFullOnes) {
  RandomTessellationRequest request;
  request.side = 1e-3;
  request.diameters.assign(16, 1.0);
  const Tessellation<3> tessellation(random_sites<3>(request));
  FilmProblem<3> problem = {.tessellation = tessellation,
                            .thickness = film_thickness(tessellation, 0.93),
                            .grain = test::hmx,
                            .elements = {.divisions = 1}};
  for (const bool has_gaps : {false, true}) {
    if (has_gaps) problem.debonded = {Debonding::open, random_faces(tessellation, 0.2, 1).faces};
    const FilmComposite<3> composite(problem);
    CompressedFactors compressed;
    SymmetricFactors full(std::numeric_limits<double>::infinity());
    for (const double shear : {1e9, 1e7, 1e5}) {
      const auto matrix = [&] { return composite.film_operator().matrix({.bulk = test::binder_bulk, .shear = shear}); };
      compressed.factorise(matrix);
      full.factorise(matrix);
      for (const auto load : {Load::shear, Load::bulk}) {
        const auto forces = forces_of(composite, {shear, test::binder_bulk}, load);
        EXPECT_NEAR(forces.dot(compressed.solve(forces)) / forces.dot(full.solve(forces)), 1.0, 1e-9);
        EXPECT_LT(compressed.iterations(), 60);
      }
    }
  }
}

// A matrix without an inverse is refused, or its solution.
TEST(CompressedFactors, RefuseASingularMatrix) {
  auto matrix = test::grid_matrix(1.0);
  matrix.coeffRef(7, 7) = 0.0;
  for (int column = 0; column < matrix.outerSize(); ++column) {
    for (test::Sparse::InnerIterator at(matrix, column); at; ++at) {
      if (at.row() == 7 || column == 7) at.valueRef() = 0.0;
    }
  }
  CompressedFactors factors;
  EXPECT_THROW(
      {
        factors.factorise([&] { return matrix; });
        static_cast<void>(factors.solve(test::right_side(matrix)));
      },
      NumericalError);
}

}  // namespace
}  // namespace breccia::films
