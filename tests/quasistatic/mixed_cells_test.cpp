// Tests of composites of mixed cells under the quasi-static method.

#include "discretisation/mixed_cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/viscoelasticity/interconversion.hpp"

#include "quasistatic/composites.hpp"
#include "quasistatic/reduced/carson_path.hpp"
#include "quasistatic/reduced/sampling.hpp"
#include "quasistatic/stepping/log_time_stepping.hpp"
#include "test_names.hpp"

namespace breccia {
namespace {

using test::shear_and_bulk;

/// The composite random_composite() with mixed cells.
QuasistaticProblem<2> mixed_composite(int n, std::uint64_t seed, Boundary boundary) {
  auto problem = test::random_composite(n, seed, boundary);
  const auto box = test::random_discs(seed);
  problem.discretisation =
      discretise_mixed(box, n, 0, std::vector<PhaseIndex>(box.particles.size(), 1), problem.materials.size());
  return problem;
}

SampledResponses<2> sampled_mixture(const QuasistaticProblem<2>& problem, double tolerance) {
  return sample_responses(problem, shear_and_bulk,
                          matrix_path(0, carson_path(problem.materials.front(), test::relaxation_window)),
                          {.tolerance = tolerance});
}

class MixedCells : public testing::TestWithParam<Boundary> {};

// The strains of the phases are kept with the snapshots: reduced responses are those of the stiffness at every modulus.
TEST_P(MixedCells, TheReducedResponseIsThatOfSingleElasticSolutions) {
  const auto problem = mixed_composite(30, 1, GetParam());
  const auto responses = sampled_mixture(problem, 1e-6).responses;
  for (const auto& moduli : carson_path(problem.materials.front(), test::relaxation_window)) {
    const auto exact = sample_responses(problem, shear_and_bulk, matrix_path(0, std::array{moduli})).responses;
    for (std::size_t l = 0; l < 2; ++l) {
      EXPECT_NEAR(responses[l].modulus(moduli) / exact[l].modulus(moduli), 1.0, 2e-6) << moduli.shear;
    }
  }
}

TEST_P(MixedCells, TheReducedResponseInTimeAgreesWithStepping) {
  const auto problem = mixed_composite(24, 2, GetParam());
  const auto responses = sampled_mixture(problem, 1e-6).responses;
  const auto times = test::logarithmic(1e-3 * test::relaxation_window.begin, test::relaxation_window.end, 60);
  const auto steps = run_log_time_stepping(problem, shear_and_bulk, times).responses;
  for (std::size_t l = 0; l < 2; ++l) {
    const auto compliance = creep_compliance(responses[l], problem.materials.front());
    const auto modulus = relaxation_modulus(compliance);
    for (std::size_t i = 0; i < times.size(); ++i) {
      if (times[i] < test::relaxation_window.begin) continue;
      const double exact = GetParam() == Boundary::traction ? compliance.at(times[i]) : modulus.at(times[i]);
      EXPECT_NEAR(steps[l].values[i] / exact, 1.0, 1e-3) << times[i] << " s";
    }
  }
}

TEST_P(MixedCells, TheIterativeSolverFindsTheSame) {
  auto problem = mixed_composite(40, 1, GetParam());
  const auto direct = sampled_mixture(problem, 1e-5).responses;
  problem.linear.method = LinearMethod::iterative;
  const auto iterative = sampled_mixture(problem, 1e-5).responses;
  const auto path = carson_path(problem.materials.front(), test::relaxation_window);
  for (std::size_t i = 0; i < path.size(); i += 10) {
    EXPECT_NEAR(iterative[0].modulus(path[i]) / direct[0].modulus(path[i]), 1.0, 1e-5);
  }
}

// Mean stress and mean strain of the fields are those of the curve.
TEST_P(MixedCells, TheMeanOfTheFieldsIsThatOfTheResponse) {
  const auto problem = mixed_composite(24, 1, GetParam());
  const auto result = sampled_mixture(problem, 1e-7);
  const double time = 1e-5;
  const auto fields = result.fields(0, std::span(problem.materials).first(1), time);
  double stress = 0.0, strain = 0.0;
  const auto count = static_cast<double>(fields.stress.size());
  for (std::size_t p = 0; p < fields.stress.size(); ++p) {
    stress += fields.stress[p][3] / count;
    strain += 2.0 * fields.strain[p][2] / count;
  }
  const auto compliance = creep_compliance(result.responses[0], problem.materials.front());
  if (GetParam() == Boundary::traction) {
    EXPECT_NEAR(stress, 1.0, 1e-5);
    EXPECT_NEAR(strain / compliance.at(time), 1.0, 1e-5);
  } else {
    EXPECT_NEAR(strain, 1.0, 1e-9);
    EXPECT_NEAR(stress / relaxation_modulus(compliance).at(time), 1.0, 1e-5);
  }
}

INSTANTIATE_TEST_SUITE_P(Boundaries, MixedCells,
                         testing::Values(Boundary::displacement, Boundary::traction, Boundary::periodic),
                         test::by_words);

TEST(MixedCellsOfOneMaterial, AreHomogeneous) {
  auto problem = mixed_composite(20, 1, Boundary::displacement);
  problem.materials[1] = problem.materials[0];
  problem.materials[1].shear = PronySeries(7e6);
  problem.materials[0].shear = PronySeries(7e6);
  const Moduli moduli = {.bulk = 3.6e9, .shear = 7e6};
  const auto responses = sample_responses(problem, shear_and_bulk, matrix_path(0, std::array{moduli})).responses;
  EXPECT_NEAR(responses[0].modulus(moduli) / 7e6, 1.0, 1e-9);
  EXPECT_NEAR(responses[1].modulus(moduli) / (3.6e9 + 7e6 / 3.0), 1.0, 1e-9);
}

// In layers under a shear along them the stress is uniform, so that the series mixture of the cut cells is exact.
TEST(MixedCellsOfALaminate, InSeriesAreExact) {
  // A disc so large that its side is straight; it ends in the middle of a column.
  constexpr int n = 8;
  const double share = 0.5 + 0.5 / n;
  const Microstructure<2> box = {1.0, Walls::hard, {Disc{{-1e3 + share, 0.5}, 2e3}}};
  const std::array<PhaseIndex, 1> disc = {1};
  const QuasistaticProblem<2> problem = {.discretisation = discretise_mixed(box, n, 0, disc, 2),
                                         .materials = {{"soft", 1.0, PronySeries(5.0), PronySeries(1.0)},
                                                       {"stiff", 1.0, PronySeries(70.0), PronySeries(40.0)}},
                                         .boundary = Boundary::traction};
  const Moduli soft = {.bulk = 5.0, .shear = 1.0};
  const auto response =
      sample_responses(problem, std::array{Load::shear}, matrix_path(0, std::array{soft})).responses[0];
  EXPECT_NEAR(response.modulus(soft), 1.0 / ((1.0 - share) / 1.0 + share / 40.0), 1e-9);
}

// Three snapshots contain the solution under the bulk load to the last digit, while the shear load needs more: the
// error estimate of the bulk load, which is then rounding, must not cause ever more snapshots.
TEST(MixedCellsOfARegularArray, NeedFewSnapshots) {
  constexpr double side = 6e-3;
  Microstructure<2> box = {side, Walls::hard, {}};
  for (const double x : {0.25 * side, 0.75 * side}) {
    for (const double y : {0.25 * side, 0.75 * side}) box.particles.push_back({{x, y}, side / 3.0});
  }
  const Material binder = {"binder", 1000.0, PronySeries(1e9), PronySeries(1e4, {{1e-2, 5e5}})};
  const std::vector<PhaseIndex> discs(box.particles.size(), 1);
  const QuasistaticProblem<2> problem = {.discretisation = discretise_mixed(box, 24, 0, discs, 2),
                                         .materials = {binder, {"filler", 2000.0, PronySeries(10e9), PronySeries(5e9)}},
                                         .boundary = Boundary::traction};
  const auto responses = sample_responses(problem, shear_and_bulk,
                                          matrix_path(0, relaxation_path(binder, {1e-3, 50e-3})), {.tolerance = 1e-5})
                             .responses;
  for (const auto& response : responses) EXPECT_LT(response.snapshots.size(), 10U) << name_of(response.load);
}

TEST(MixedCellsRefuse, VolumetricStrainsOfPoints) {
  auto problem = mixed_composite(20, 1, Boundary::displacement);
  problem.volumetric = Volumetric::standard;
  EXPECT_THROW((void)sampled_mixture(problem, 1e-3), InputError);
}

}  // namespace
}  // namespace breccia
