#include "quasistatic/reduced/reduced_basis.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "quasistatic/composites.hpp"
#include "quasistatic/reduced/cell_composite.hpp"
#include "quasistatic/reduced/residual_rounding.hpp"

namespace breccia::quasistatic {
namespace {

const Moduli reference = {.bulk = 3.0, .shear = 1.0};
const std::vector<Material> materials = {{"soft", 1.0, PronySeries(0.0), PronySeries(0.0)},
                                         {"hard", 1.0, PronySeries(20.0), PronySeries(10.0)}};

const std::vector<VaryingPhase> matrix_alone = {{0, "matrix"}};

/// A basis, and solutions to add to it.
class Basis {
 public:
  Basis(const Discretisation<2>& discretisation, Boundary boundary, Load load)
      : composite_({.discretisation = discretisation, .materials = materials, .boundary = boundary}, matrix_alone),
        solver_(composite_, {.method = LinearMethod::direct}),
        basis_(composite_, load, {reference}) {}

  void add(const Moduli& matrix) { basis_.add(solution(matrix), {matrix}); }

  /// The solution for a matrix, under the prescribed strain or the unit traction.
  [[nodiscard]] Displacement solution(const Moduli& matrix) {
    solver_.prepare(basis_.response().parameters(matrix));
    return solver_.solve(basis_.load(), composite_.zero());
  }

  /// Energy of a displacement with a matrix of these moduli.
  [[nodiscard]] double energy(const Displacement& displacement, const Moduli& matrix) const {
    return work(composite_.forces(basis_.response().parameters(matrix), basis_.load(), displacement), displacement);
  }

  [[nodiscard]] const ReducedBasis<CellComposite<2>>& get() const { return basis_; }
  [[nodiscard]] const ReducedResponse& response() const { return basis_.response(); }
  [[nodiscard]] double area() const { return composite_.volume(); }

 private:
  CellComposite<2> composite_;
  CellSolver<2> solver_;
  ReducedBasis<CellComposite<2>> basis_;
};

/// A discretisation whose left half is hard.
Discretisation<2> layers() {
  Discretisation<2> discretisation(Grid<2>{{8, 8}, 1.0});
  discretisation.paint([](const Vector<2>& position) { return position[0] < 4.0; }, 1);
  return discretisation;
}

/// A discretisation with a hard square in the middle.
Discretisation<2> inclusion() {
  Discretisation<2> discretisation(Grid<2>{{8, 8}, 1.0});
  discretisation.paint(
      [](const Vector<2>& position) { return std::abs(position[0] - 4.0) < 2.0 && std::abs(position[1] - 4.0) < 2.0; },
      1);
  return discretisation;
}

const std::vector<Moduli> others = {
    {.bulk = 3.0, .shear = 1e-4}, {.bulk = 0.5, .shear = 0.3}, {.bulk = 9.0, .shear = 40.0}};

// The shear of layers in series has one fluctuation for any contrast: the uniform strain and a single solution span all
// solutions.
TEST(ReducedBasis, OfLayersInSeriesIsExactForEveryMatrixAfterOneSolution) {
  Basis basis(layers(), Boundary::periodic, Load::shear);
  EXPECT_NEAR(basis.response().modulus(reference), 0.5 * (reference.shear + 10.0), 1e-12);  // Voigt
  basis.add({.bulk = 2.0, .shear = 0.5});
  for (const auto& matrix : others) {
    EXPECT_NEAR(basis.response().modulus(matrix) * (0.5 / matrix.shear + 0.5 / 10.0), 1.0, 1e-10) << matrix.shear;
  }
}

TEST(ReducedBasis, OfTheUniformStrainAloneGivesTheVoigtBound) {
  for (const auto load : {Load::shear, Load::diagonal_shear, Load::bulk}) {
    const Basis basis(inclusion(), Boundary::displacement, load);
    for (const auto& matrix : others) {
      const auto modulus = [&](double bulk, double shear) { return load == Load::bulk ? bulk + shear / 3.0 : shear; };
      EXPECT_NEAR(
          basis.response().modulus(matrix) / (0.75 * modulus(matrix.bulk, matrix.shear) + 0.25 * modulus(20.0, 10.0)),
          1.0, 1e-12);
    }
  }
}

TEST(ReducedBasis, IsOrthonormalInTheEnergyOfTheReferenceMatrix) {
  for (const auto boundary : test::boundaries) {
    Basis basis(inclusion(), boundary, Load::diagonal_shear);
    for (const auto& matrix : others) basis.add(matrix);
    const auto& response = basis.response();
    const auto stiffness = response.stiffness(response.parameters(reference));
    ASSERT_EQ(stiffness.rows(), 4);
    EXPECT_LT((stiffness - Eigen::MatrixXd::Identity(4, 4)).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST(ReducedBasis, ProjectsTheEnergyOfCombinations) {
  for (const auto boundary : test::boundaries) {
    Basis basis(inclusion(), boundary, Load::shear);
    for (const auto& matrix : others) basis.add(matrix);
    const Eigen::VectorXd weights{{1.0, -2.0, 0.5, 3.0}};
    const auto combination = basis.get().combination(weights);
    for (const auto& matrix : others) {
      const auto stiffness = basis.response().stiffness(basis.response().parameters(matrix));
      EXPECT_NEAR(weights.dot(stiffness * weights) / basis.energy(combination, matrix), 1.0, 1e-11);
    }
  }
}

TEST(ReducedBasis, HasTheModulusAndNoResidualAtItsSnapshots) {
  for (const auto boundary : test::boundaries) {
    Basis basis(inclusion(), boundary, Load::shear);
    for (const auto& matrix : others) basis.add(matrix);
    auto response = basis.response();
    response.residual_scale = 1.0;
    for (const auto& matrix : others) {
      const double energy = basis.energy(basis.solution(matrix), matrix) / basis.area();
      EXPECT_NEAR(response.modulus(matrix) / (boundary == Boundary::traction ? 1.0 / energy : energy), 1.0, 1e-8);
      EXPECT_LT(response.error_estimate(matrix),
                std::max(1e-9, rounding_of_error_estimate(response, std::array{matrix})));
    }
    const Moduli between = {.bulk = 3.0, .shear = 0.01};
    const double energy = basis.energy(basis.solution(between), between) / basis.area();
    EXPECT_GT(response.modulus(between), boundary == Boundary::traction ? 1.0 / energy : energy);
    EXPECT_GT(response.error_estimate(between), 1e-8);
  }
}

TEST(ReducedBasis, ApproximatesASolutionThatItHolds) {
  for (const auto boundary : test::boundaries) {
    Basis basis(inclusion(), boundary, Load::bulk);
    basis.add(others[1]);
    const auto exact = basis.solution(others[1]);
    auto difference = basis.get().approximation(std::array{others[1]});
    difference.add(-1.0, exact);
    EXPECT_LT(basis.energy(difference, others[1]), 1e-14 * basis.energy(exact, others[1]));
  }
}

TEST(ReducedBasis, TakesNoVectorTwice) {
  Basis basis(inclusion(), Boundary::periodic, Load::shear);
  basis.add(others[1]);
  basis.add(others[1]);
  EXPECT_EQ(basis.response().load_forces.size(), 2);
  EXPECT_EQ(basis.response().snapshots.size(), 2U);
}

TEST(AffineStiffness, HasAPartForEachModulusOfTheMatrix) {
  const auto stiffness = affine_stiffness(materials, matrix_alone);
  ASSERT_EQ(stiffness.parts.size(), 2U);
  EXPECT_EQ(stiffness.parts[0].parameter, (PhaseModulus{"matrix", ElasticModulus::shear}));
  EXPECT_EQ(stiffness.parts[1].parameter, (PhaseModulus{"matrix", ElasticModulus::bulk}));
  const auto moduli = stiffness.moduli_at(std::vector{7.0, 5.0});
  EXPECT_EQ(moduli[0].shear, 7.0);
  EXPECT_EQ(moduli[0].bulk, 5.0);
  EXPECT_EQ(moduli[1].shear, 10.0);
  EXPECT_EQ(moduli[1].bulk, 20.0);
}

TEST(AffineStiffness, RefusesAFillerThatRelaxes) {
  auto relaxing = materials;
  relaxing[1].bulk = PronySeries(1.0, {{1.0, 2.0}});
  EXPECT_THROW(affine_stiffness(relaxing, matrix_alone), InputError);
}

// A coating whose shear modulus varies too is one more part.
TEST(ReducedResponse, MayHavePartsOfSeveralPhases) {
  const auto one = [](double x) { return Eigen::MatrixXd::Constant(1, 1, x); };
  ReducedResponse response;
  response.constant = one(2.0);
  response.parts = matrix_parts(one(3.0), one(5.0));
  const AffinePart coating = {PhaseModulus{"coating", ElasticModulus::shear}, one(7.0)};
  response.parts.push_back(coating);
  response.load_forces = Eigen::VectorXd::Constant(1, 0.5);
  const std::vector parameters = {1.0, 10.0, 100.0};
  EXPECT_DOUBLE_EQ(response.modulus(parameters), (2.0 + 3.0 + 50.0 + 700.0) / 0.25);
  EXPECT_EQ(response.part(ElasticModulus::bulk)(0, 0), 5.0);
  EXPECT_THROW(static_cast<void>(response.parameters({.bulk = 10.0, .shear = 1.0})), InputError);
  response.parts.assign(1, coating);
  EXPECT_THROW(static_cast<void>(response.part(ElasticModulus::shear)), InputError);
}

}  // namespace
}  // namespace breccia::quasistatic
