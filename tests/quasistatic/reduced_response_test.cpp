#include "breccia/quasistatic/reduced_response.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/viscoelasticity/interconversion.hpp"

#include "quasistatic/composites.hpp"
#include "quasistatic/reduced/carson_path.hpp"
#include "quasistatic/reduced/greedy_sampling.hpp"
#include "quasistatic/reduced/reduced_response_state.hpp"
#include "quasistatic/reduced/sampling.hpp"
#include "quasistatic/stepping/log_time_stepping.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using test::shear_and_bulk;

std::vector<ReducedResponse> sampled(const QuasistaticProblem<2>& problem, double tolerance = 1e-6) {
  return sample_responses(problem, shear_and_bulk,
                          matrix_path(0, carson_path(problem.materials.front(), test::relaxation_window)),
                          {.tolerance = tolerance})
      .responses;
}

/// Expects the two methods of time integration to differ by no more than the error of the steps, which falls with their
/// square.
void expect_agreement_with_stepping(const QuasistaticProblem<2>& problem) {
  const auto responses = sampled(problem);
  const auto times = test::logarithmic(1e-3 * test::relaxation_window.begin, test::relaxation_window.end, 60);
  const auto stepped = run_log_time_stepping(problem, shear_and_bulk, times).responses;
  for (std::size_t l = 0; l < responses.size(); ++l) {
    const auto compliance = creep_compliance(responses[l], problem.materials.front());
    const auto modulus = relaxation_modulus(compliance);
    for (std::size_t i = 0; i < times.size(); ++i) {
      if (times[i] < test::relaxation_window.begin) continue;
      const double value = problem.boundary == Boundary::traction ? compliance.at(times[i]) : modulus.at(times[i]);
      const double difference = std::abs(value / stepped[l].values[i] - 1.0);
      EXPECT_LT(difference, 1e-3) << times[i];
      EXPECT_LT(difference, 2.0 * stepped[l].error_estimates[i] + 1e-4) << times[i];
    }
  }
}

TEST(ReducedResponse, AgreesWithSteppingThroughTime) {
  for (const auto boundary : test::boundaries) {
    expect_agreement_with_stepping(test::random_composite(20, 1, boundary));
    expect_agreement_with_stepping(test::model_composite(24, Volumetric::standard, boundary));
  }
}

TEST(ReducedResponse, AgreesWhereTheBulkModulusOfTheMatrixRelaxesToo) {
  for (const auto boundary : test::boundaries) {
    auto problem = test::random_composite(16, 2, boundary);
    problem.materials.front().bulk = PronySeries(1e8, {{3e-7, 2e9}, {2e-5, 1e9}});
    expect_agreement_with_stepping(problem);
  }
}

TEST(ReducedResponse, TwoWaysToTheSpectrumAgree) {
  // With a bulk modulus that relaxes slightly the compliance is computed by the network; without this relaxation, by
  // poles.
  const auto problem = test::random_composite(20, 3, Boundary::traction);
  const auto& matrix = problem.materials.front();
  auto trace = matrix;
  trace.bulk = PronySeries(matrix.bulk.equilibrium() * (1.0 - 1e-9), {{1e-5, matrix.bulk.equilibrium() * 1e-9}});
  for (const auto& response : sampled(problem)) {
    const auto poles = creep_compliance(response, matrix), network = creep_compliance(response, trace);
    for (const double time : test::logarithmic(1e-12, 1e4, 3)) {
      EXPECT_NEAR(network.at(time) / poles.at(time), 1.0, 1e-7) << time;
    }
  }
}

TEST(ReducedResponse, AHomogeneousBoxIsItsMatrix) {
  const Material matrix = {"m", 1000.0, PronySeries(2e6, {{3e-3, 1e6}}), PronySeries(0.1e6, {{1e-3, 0.5e6}})};
  for (const auto boundary : test::boundaries) {
    const auto problem = test::homogeneous(matrix, boundary);
    const auto responses =
        sample_responses(problem, std::array{Load::diagonal_shear}, matrix_path(0, carson_path(matrix, {1e-4, 1.0})))
            .responses;
    EXPECT_NEAR(responses[0].modulus({.bulk = 7e6, .shear = 3e6}) / 3e6, 1.0, 1e-9);
    const auto found = relaxation_modulus(creep_compliance(responses[0], matrix));
    for (const double time : test::logarithmic(1e-5, 1.0, 4))
      EXPECT_NEAR(found.at(time) / matrix.shear.at(time), 1.0, 1e-8);
  }
}

TEST(ReducedResponse, ABoxOfOneMaterialWithAnElasticBulkModulusShowsItsShearModulus) {
  const Material matrix = {"m", 1000.0, PronySeries(2e6), PronySeries(0.0, {{1e-3, 0.5e6}, {1e-2, 0.1e6}})};
  for (const auto boundary : test::boundaries) {
    const auto problem = test::homogeneous(matrix, boundary);
    const auto response =
        sample_responses(problem, std::array{Load::shear}, matrix_path(0, carson_path(matrix, {1e-4, 0.1})))
            .responses[0];
    const auto found = relaxation_modulus(creep_compliance(response, matrix));
    for (const double time : test::logarithmic(1e-4, 0.1, 4)) {
      EXPECT_NEAR(found.at(time) / matrix.shear.at(time), 1.0, 1e-8);
    }
  }
}

TEST(ReducedResponse, MoreSnapshotsMeetAFinerToleranceAndTheEstimateTells) {
  const auto problem = test::random_composite(24, 4, Boundary::displacement);
  const auto path = carson_path(problem.materials.front(), test::relaxation_window);
  const auto exact = sampled(problem, 1e-10);
  std::size_t snapshots = 0;
  for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
    const auto responses = sampled(problem, tolerance);
    EXPECT_GT(responses[0].snapshots.size(), snapshots);
    snapshots = responses[0].snapshots.size();
    for (std::size_t l = 0; l < responses.size(); ++l) {
      EXPECT_LE(responses[l].snapshots.back().error_before, tolerance);
      for (const auto& moduli : path) {
        const double error = responses[l].modulus(moduli) / exact[l].modulus(moduli) - 1.0;
        EXPECT_GT(error, -1e-9) << "from above";
        EXPECT_LT(error, tolerance);
        EXPECT_LT(error, 20.0 * responses[l].error_estimate(moduli) + 1e-9);
      }
    }
  }
}

TEST(ReducedResponse, LowerPeriodicAndUpperAreInOrderWithinVoigtAndReuss) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    std::vector<std::vector<ReducedResponse>> by_boundary;
    for (const auto boundary : {Boundary::traction, Boundary::periodic, Boundary::displacement}) {
      by_boundary.push_back(sampled(test::random_composite(24, seed, boundary), 1e-5));
    }
    const auto problem = test::random_composite(24, seed, Boundary::periodic);
    const double filled = problem.discretisation.fractions(2)[1];
    const auto& filler = problem.materials[1];
    for (const auto& moduli : carson_path(problem.materials.front(), test::relaxation_window)) {
      for (std::size_t l = 0; l < shear_and_bulk.size(); ++l) {
        const auto of = [&](double bulk, double shear) {
          return shear_and_bulk[l] == Load::bulk ? bulk + shear / 3.0 : shear;
        };
        const double in_matrix = of(moduli.bulk, moduli.shear);
        const double in_filler = of(filler.bulk.equilibrium(), filler.shear.equilibrium());
        const double lower = by_boundary[0][l].modulus(moduli), periodic = by_boundary[1][l].modulus(moduli),
                     upper = by_boundary[2][l].modulus(moduli);
        EXPECT_LT(1.0 / ((1.0 - filled) / in_matrix + filled / in_filler), lower);
        EXPECT_LT(lower, periodic);
        EXPECT_LT(periodic, upper);
        EXPECT_LT(upper, (1.0 - filled) * in_matrix + filled * in_filler);
      }
    }
  }
}

TEST(ReducedResponse, ANearlyRigidFillerUnderTractionAgreesWithStepping) {
  auto problem = test::model_composite(16, Volumetric::averaged, Boundary::traction);
  auto& filler = problem.materials[1];
  filler.bulk = filler.shear = PronySeries(1e13);
  expect_agreement_with_stepping(problem);
}

TEST(ReducedResponse, AMatrixThatHardlyRelaxesIsSampledAtItsEnds) {
  auto problem = test::model_composite(16, Volumetric::averaged, Boundary::displacement);
  auto& matrix = problem.materials[0];
  matrix.shear = PronySeries(1e6, {{1e-2, 3e4}});
  expect_agreement_with_stepping(problem);
  // The bulk modulus of a stage's result may rise.
  matrix.shear = PronySeries(1e6);
  matrix.bulk = PronySeries::difference(PronySeries(2e6), PronySeries(0.0, {{1e-2, 5e5}}));
  const auto path = carson_path(matrix, {1e-3, 1e-1});
  EXPECT_NEAR(path.front().bulk, 1.5e6, 5e3);
  EXPECT_NEAR(path.back().bulk, 2e6, 5e3);
  EXPECT_GT(path.size(), 3U);
}

TEST(ReducedResponse, DirectAndIterativeSolversAgree) {
  for (const auto boundary : test::boundaries) {
    auto problem = test::random_composite(32, 5, boundary);
    problem.linear.method = LinearMethod::direct;
    const auto direct = sampled(problem, 1e-5);
    problem.linear.method = LinearMethod::iterative;
    const auto iterative = sampled(problem, 1e-5);
    for (const auto& moduli : carson_path(problem.materials.front(), test::relaxation_window)) {
      EXPECT_NEAR(iterative[0].modulus(moduli) / direct[0].modulus(moduli), 1.0, 1e-5);
    }
  }
}

TEST(ReducedResponse, OfElasticMaterialsNeedsASnapshot) {
  const auto problem = test::model_composite(8, Volumetric::averaged, Boundary::periodic);
  auto response = sampled(problem).front();
  const Material elastic = {"elastic", 1000.0, PronySeries(2e6), PronySeries(1e6)};
  EXPECT_GT(creep_compliance(response, elastic).instantaneous(), 0.0);
  response.snapshots.clear();
  EXPECT_THROW(static_cast<void>(creep_compliance(response, elastic)), InputError);
}

TEST(ReducedResponse, WithANumberThatIsNoLoadOrModulusIsNotReadFromAState) {
  const test::TemporaryDirectory directory;
  const auto is_read = [&](const ReducedResponse& response) {
    const auto path = directory.path() / "state.h5";
    StateWriter writer(path, {"deck", "version"});
    save(writer, "/response", response);
    writer.commit();
    try {
      static_cast<void>(read_response(StateReader(path), "/response"));
    } catch (const FileError&) {
      return false;
    }
    return true;
  };
  const auto sound = sampled(test::model_composite(8, Volumetric::averaged, Boundary::periodic)).front();
  EXPECT_TRUE(is_read(sound));
  auto changed = sound;
  changed.load = static_cast<Load>(77);
  EXPECT_FALSE(is_read(changed));
  changed = sound;
  changed.boundary = static_cast<Boundary>(-1);
  EXPECT_FALSE(is_read(changed));
  changed = sound;
  changed.parts.back().parameter.modulus = static_cast<ElasticModulus>(2);
  EXPECT_FALSE(is_read(changed));
}

// Beside a basis of three times as many vectors, the error of the one that is kept is no larger than it says.
TEST(Sampling, KeepsABasisThatMissesTheToleranceWithItsError) {
  const auto problem = test::random_composite(12, 7, Boundary::displacement);
  const auto path = carson_path(problem.materials.front(), test::relaxation_window);
  const auto kept =
      sample_responses(problem, shear_and_bulk, matrix_path(0, path), {.tolerance = 1e-9, .most_snapshots = 4});
  const auto finer = sample_responses(problem, shear_and_bulk, matrix_path(0, path), {.tolerance = 1e-9});
  constexpr double of_the_solver = 1e-8;
  double most = 0.0;
  for (std::size_t load = 0; load < shear_and_bulk.size(); ++load) {
    const auto& response = kept.responses[load];
    ASSERT_EQ(response.snapshots.size(), 4U);
    double stated = 0.0, error = 0.0;
    for (const auto& moduli : path) {
      stated = std::max(stated, response.error_estimate(moduli));
      error = std::max(error, std::abs(response.modulus(moduli) / finer.responses[load].modulus(moduli) - 1.0));
    }
    EXPECT_LE(error, std::max(2.0 * stated, of_the_solver));
    most = std::max(most, stated);
  }
  EXPECT_GT(most, 1e-9);
}

TEST(Sampling, RefusesAnErrorAboveATenthAndNeedsAnElasticFiller) {
  const SamplingOptions options = {.tolerance = 1e-5};
  const std::vector<Moduli> soft_to_stiff = {{3e9, 2.0}, {3e9, 5e8}};
  const auto of_matrix = matrix_path(0, soft_to_stiff);
  EXPECT_NO_THROW(quasistatic::require_useful(0.035, of_matrix, options));
  EXPECT_THAT([&] { quasistatic::require_useful(0.2, of_matrix, options); },
              testing::ThrowsMessage<NumericalError>(testing::HasSubstr("the sampled moduli go from 2 to 3e+09 Pa")));
  auto problem = test::random_composite(12, 7, Boundary::displacement);
  const auto path = carson_path(problem.materials.front(), test::relaxation_window);
  EXPECT_THROW(sample_responses(problem, shear_and_bulk, matrix_path(0, {})), InputError);
  problem.materials[1].shear = PronySeries(1e9, {{1e-6, 1e9}});
  EXPECT_THROW(sample_responses(problem, shear_and_bulk, matrix_path(0, path)), InputError);
}

}  // namespace
}  // namespace breccia
