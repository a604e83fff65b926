#include "dynamics/dynamic_problem.hpp"

#include <cmath>

#include <Eigen/Dense>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "discretisation/cell_shape.hpp"
#include "dynamics/nodal_mass.hpp"
#include "materials.hpp"
#include "messages.hpp"

namespace breccia {
namespace {

using testing_materials::relaxing;
using testing_materials::soft;
using testing_materials::stiff;

TEST(StrainRamp, RunsFromZeroToOneAroundItsMidpoint) {
  const StrainRamp ramp(0.4);
  EXPECT_EQ(ramp.at(-0.2), 0.0);
  EXPECT_EQ(ramp.at(0.0), 0.5);
  EXPECT_EQ(ramp.at(0.2), 1.0);
  EXPECT_DOUBLE_EQ(ramp.at(0.07) + ramp.at(-0.07), 1.0);
  EXPECT_EQ(ramp.at(9.0), 1.0);
}

TEST(StrainRamp, RateIsARaisedCosine) {
  const StrainRamp ramp(2.0);
  const auto rate = [&](double t) { return (ramp.at(t + 1e-6) - ramp.at(t - 1e-6)) / 2e-6; };
  EXPECT_NEAR(rate(0.0), 1.0, 1e-9);
  EXPECT_NEAR(rate(0.5), 0.5, 1e-9);
  EXPECT_NEAR(rate(0.999), 0.0, 1e-5);
}

TEST(StrainRamp, RefusesANegativeDuration) {
  EXPECT_THROW(StrainRamp(-1.0), InputError);
}

/// Highest frequency of a free body [rad/s], from the assembled matrices.
double highest_frequency(const DynamicProblem<2>& problem) {
  const auto& grid = problem.discretisation.grid();
  std::vector<double> masses;
  grid.for_each_node([&](const Index<2>& node) { masses.push_back(dynamics::nodal_mass(problem, node)); });
  const auto size = static_cast<Eigen::Index>(2 * masses.size());
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(size, size);
  for (int row = 0; row < grid.rows(); ++row) {
    for (int column = 0; column < grid.columns(); ++column) {
      CellShape<2>::PointModuli moduli{};
      for (std::size_t p = 0; p < moduli.size(); ++p) {
        const auto& material = problem.materials[problem.discretisation.cell({column, row})[p]];
        moduli[p] = {material.bulk.unrelaxed(), material.shear.unrelaxed()};
      }
      const auto cell = CellShape<2>::stiffness(moduli, problem.volumetric);
      const Eigen::Index corner = 2 * (row * (grid.columns() + 1) + column), up = 2 * (grid.columns() + 1);
      const std::array<Eigen::Index, 4> dofs = {corner, corner + 2, corner + up, corner + up + 2};
      for (std::size_t a = 0; a < 4; ++a) {
        for (std::size_t b = 0; b < 4; ++b) {
          stiffness.block<2, 2>(dofs[a], dofs[b]) +=
              cell.block<2, 2>(static_cast<Eigen::Index>(2 * a), static_cast<Eigen::Index>(2 * b));
        }
      }
    }
  }
  Eigen::VectorXd scale(size);
  for (Eigen::Index i = 0; i < size; ++i) scale[i] = 1.0 / std::sqrt(masses[static_cast<std::size_t>(i / 2)]);
  const Eigen::MatrixXd scaled = scale.asDiagonal() * stiffness * scale.asDiagonal();
  return std::sqrt(
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff());
}

TEST(StableTimeStep, IsBelowAndCloseToTheLimitOfTheAssembledSystem) {
  for (const auto volumetric : {Volumetric::averaged, Volumetric::standard}) {
    for (const double mass_scaling : {1.0, 1e4}) {
      DynamicProblem<2> problem{testing_materials::disc_in_box(10), {soft, stiff}};
      problem.volumetric = volumetric;
      problem.mass_scaling = mass_scaling;
      const double limit = 2.0 / highest_frequency(problem);
      const double step = stable_time_step(problem.discretisation, problem.materials, volumetric, mass_scaling);
      EXPECT_LE(step, limit);
      EXPECT_GE(step, 0.7 * limit);
    }
  }
}

TEST(StableTimeStep, CountsModuliUnrelaxed) {
  const Discretisation<2> box(Grid<2>{{2, 2}, 0.1});
  const Material unrelaxed = {"u", relaxing.density, PronySeries(relaxing.bulk.unrelaxed()),
                              PronySeries(relaxing.shear.unrelaxed())};
  EXPECT_DOUBLE_EQ(stable_time_step(box, {relaxing}, Volumetric::averaged, 1.0),
                   stable_time_step(box, {unrelaxed}, Volumetric::averaged, 1.0));
}

TEST(StableTimeStep, RefusesIncompleteProblems) {
  const Discretisation<2> box(Grid<2>{{2, 2}, 0.1}, 1);
  EXPECT_THROW((void)stable_time_step(box, {soft}, Volumetric::averaged, 1.0), InputError);
  EXPECT_THROW((void)stable_time_step(box, {soft, Material{}}, Volumetric::averaged, 1.0), InputError);
  const Discretisation<2> nothing(Grid<2>{{2, 2}, 0.1}, no_phase);
  EXPECT_THROW((void)stable_time_step(nothing, {soft}, Volumetric::averaged, 1.0), InputError);
}

TEST(DynamicProblem, RefusesATimeStepAboveTheStableOne) {
  DynamicProblem<2> problem{testing_materials::disc_in_box(10), {soft, stiff}};
  const double limit = stable_time_step(problem.discretisation, problem.materials, problem.volumetric, 1.0);
  problem.time_step = limit;
  EXPECT_NO_THROW(require_stable(problem));
  for (const double step : {1.001 * limit, 0.0, -limit, std::nan("")}) {
    problem.time_step = step;
    EXPECT_THROW(require_stable(problem), InputError);
  }
}

TEST(DynamicProblem, RefusesAMassScalingFactorThatIsNotPositive) {
  DynamicProblem<2> problem{testing_materials::disc_in_box(10), {soft, stiff}};
  problem.time_step = 1e-9;
  for (const double factor : {-1.0, 0.0, std::nan("")}) {
    problem.mass_scaling = factor;
    EXPECT_THAT(test::message_of<InputError>([&] { require_stable(problem); }),
                testing::HasSubstr("mass scaling factor of"));
  }
}

}  // namespace
}  // namespace breccia
