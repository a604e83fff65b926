#include "films/solver/compressed_factors.hpp"

#include <array>
#include <cmath>
#include <cstdint>
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
  const auto found = minimal_residuals(multiply, none, right_side, 1e-12);
  EXPECT_EQ(found.iterations, 4);
  EXPECT_LT((found.solution - solution).norm(), 1e-12);
  EXPECT_LT(found.residual, 1e-12);
}

TEST(MinimalResiduals, SolveInOneStepWithTheInverse) {
  const auto matrix = unsymmetric_matrix();
  const Eigen::MatrixXd inverse = matrix.inverse();
  const auto multiply = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd { return matrix * x; };
  const auto precondition = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd { return inverse * x; };
  const auto found = minimal_residuals(multiply, precondition, Eigen::VectorXd::Ones(4), 1e-12);
  EXPECT_EQ(found.iterations, 1);
  EXPECT_LT((matrix * found.solution - Eigen::VectorXd::Ones(4)).norm(), 1e-12);
  const auto zero = minimal_residuals(multiply, precondition, Eigen::VectorXd::Zero(4), 1e-12);
  EXPECT_EQ(zero.iterations, 0);
  EXPECT_EQ(zero.solution, Eigen::VectorXd::Zero(4));
}

// With an inverse that is off by a thousandth, anew each time, three steps leave 1e-9 and the next ones go on.
TEST(MinimalResiduals, DoNotNeedALinearPreconditioner) {
  const auto matrix = unsymmetric_matrix();
  const Eigen::MatrixXd inverse = matrix.inverse();
  const auto multiply = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd { return matrix * x; };
  int calls = 0;
  const auto precondition = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
    ++calls;
    return inverse * x + 1e-3 * std::sin(calls) * x.norm() * Eigen::VectorXd::Unit(4, calls % 4);
  };
  const auto found = minimal_residuals(multiply, precondition, Eigen::VectorXd::Ones(4), 1e-13);
  EXPECT_LT((matrix * found.solution - Eigen::VectorXd::Ones(4)).norm(), 3e-13);
}

// A cyclic shift has the residual of the right side until the last of as many steps as there are rows, more than a
// cycle has: the iterations end.
TEST(MinimalResiduals, EndWhereTheyAreStuck) {
  constexpr Eigen::Index rows = 200;
  int products = 0;
  const auto shift = [&](const Eigen::VectorXd& x) {
    ++products;
    Eigen::VectorXd y(rows);
    y << x.tail(rows - 1), x[0];
    return y;
  };
  const auto none = [](const Eigen::VectorXd& x) { return x; };
  const auto found = minimal_residuals(shift, none, Eigen::VectorXd::Unit(rows, 0), 1e-10);
  EXPECT_NEAR(found.residual, 1.0, 1e-12);
  EXPECT_LE(products, 60);
  const auto broken = [](const Eigen::VectorXd& x) -> Eigen::VectorXd { return x * std::nan(""); };
  EXPECT_LE(minimal_residuals(shift, broken, Eigen::VectorXd::Unit(rows, 0), 1e-10).iterations, 1);
}

TEST(CompressedFactors, SolveForOneMatrixAfterTheOther) {
  CompressedFactors factors(std::numeric_limits<double>::infinity());
  for (const double stiffness : {1.0, 1e3, 1e6}) {
    const auto matrix = test::grid_matrix(stiffness);
    factors.factorise([&] { return matrix; });
    const auto load = test::right_side(matrix);
    const auto solution = factors.solve(load);
    const double residual = (matrix.selfadjointView<Eigen::Lower>() * solution - load).norm() / load.norm();
    EXPECT_LT(residual, 1e-7);
    EXPECT_NEAR(factors.effort().residual / residual, 1.0, 1e-3);
    EXPECT_GT(factors.effort().iterations, 0);
    EXPECT_EQ(factors.effort().factorisations, 0);
  }
}

TEST(CompressedFactors, AreLeftWhenTheirObserverThrows) {
  CompressedFactors factors(std::numeric_limits<double>::infinity());
  const auto matrix = test::grid_matrix(1e3);
  const auto load = test::right_side(matrix);
  factors.factorise([&] { return matrix; });
  const auto undisturbed = factors.solve(load);
  const int all = factors.effort().iterations;
  int iterations = 0;
  factors.watch([&] {
    ++iterations;
    throw Interrupted("enough");
  });
  EXPECT_THROW(static_cast<void>(factors.solve(load)), Interrupted);
  EXPECT_EQ(iterations, 1);
  ASSERT_GT(all, iterations) << "there would have been more";
  factors.watch([] {});
  EXPECT_EQ(factors.solve(load), undisturbed);
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
    CompressedFactors compressed(std::numeric_limits<double>::infinity());
    SymmetricFactors full(std::numeric_limits<double>::infinity());
    for (const double shear : {1e9, 1e7, 1e5}) {
      const auto matrix = [&] { return composite.film_operator().matrix({.bulk = test::binder_bulk, .shear = shear}); };
      compressed.factorise(matrix);
      full.factorise(matrix);
      for (const auto load : {Load::shear, Load::bulk}) {
        const auto forces = forces_of(composite, {shear, test::binder_bulk}, load);
        EXPECT_NEAR(forces.dot(compressed.solve(forces)) / forces.dot(full.solve(forces)), 1.0, 1e-9);
        EXPECT_LT(compressed.effort().iterations, 60);
      }
    }
  }
}

/// Expects that the moduli of a problem by compressed factors are those by full ones.
void expect_same_moduli(const FilmProblem<3>& problem) {
  constexpr std::int64_t none = 0, all = std::numeric_limits<std::int64_t>::max();
  const FilmComposite<3> composite(problem);
  FilmSolver<3> compressed(composite, none), full(composite, all);
  for (auto* solver : {&compressed, &full}) solver->prepare(std::array{1e6, test::binder_bulk});
  for (const auto load : {Load::shear, Load::bulk}) {
    const auto one = compressed.solve(load, composite.zero()), other = full.solve(load, composite.zero());
    EXPECT_NEAR(compressed.modulus(load, one) / full.modulus(load, other), 1.0, 1e-9);
  }
  EXPECT_FALSE(compressed.effort().is_direct);
  EXPECT_GT(compressed.effort().iterations, 0);
  EXPECT_LT(compressed.effort().largest_residual, 1e-6);
  EXPECT_TRUE(full.effort().is_direct);
}

TEST(CompressedFactors, ServeFilmsOfAllKinds) {
  RandomTessellationRequest request;
  request.side = 1e-3;
  for (int i = 0; i < 6; ++i) request.diameters.push_back(1.0 + 0.4 * i);
  const Tessellation<3> tessellation(random_sites<3>(request));
  const FilmProblem<3> bonded = {.tessellation = tessellation,
                                 .thickness = film_thickness(tessellation, 0.93),
                                 .grain = test::hmx,
                                 .elements = {.divisions = 1}};
  auto resolved = bonded;
  resolved.layers = 1;
  expect_same_moduli(resolved);
  for (const auto kind : {Debonding::slip, Debonding::sealed}) {
    auto debonded = bonded;
    debonded.debonded = {kind, random_faces(tessellation, 0.3, 1).faces};
    expect_same_moduli(debonded);
  }
  auto crystals = bonded;
  StiffnessTensor<3> cubic = StiffnessTensor<3>::Zero();
  cubic.topLeftCorner<3, 3>().setConstant(8e9);
  cubic.diagonal() << 20e9, 20e9, 20e9, 9e9, 9e9, 9e9;
  crystals.crystals.assign(tessellation.size(), cubic);
  expect_same_moduli(crystals);
}

// Two rows and columns that differ by 1e-9 of a diagonal are one in single precision: full factors take over.
TEST(CompressedFactors, GiveWayToFullOnes) {
  auto matrix = test::grid_matrix(1.0);
  const auto last = matrix.rows();
  matrix.conservativeResize(last + 2, last + 2);
  for (Eigen::Index i = 0; i < 2; ++i) matrix.insert(last + i, last + i) = 1.0 + 1e-9;
  matrix.insert(last + 1, last) = 1.0;
  CompressedFactors factors(std::numeric_limits<double>::infinity());
  factors.factorise([&] { return matrix; });
  Eigen::VectorXd load = test::right_side(matrix);
  const auto solution = factors.solve(load);
  EXPECT_LT((matrix.selfadjointView<Eigen::Lower>() * solution - load).norm(), 1e-6 * load.norm());
  EXPECT_GT(factors.effort().factorisations, 0);
  // The solution does not depend on those before it.
  EXPECT_EQ(factors.solve(load), solution);
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
  CompressedFactors factors(std::numeric_limits<double>::infinity());
  EXPECT_THROW(
      {
        factors.factorise([&] { return matrix; });
        static_cast<void>(factors.solve(test::right_side(matrix)));
      },
      NumericalError);
}

}  // namespace
}  // namespace breccia::films
