// Tests of reduced responses in which the moduli of several phases vary.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/viscoelasticity/interconversion.hpp"

#include "checkpoint/checkpoint.hpp"
#include "discretisation/labels.hpp"
#include "messages.hpp"
#include "quasistatic/composites.hpp"
#include "quasistatic/reduced/carson_path.hpp"
#include "quasistatic/reduced/sampled_moduli.hpp"
#include "quasistatic/reduced/sampling.hpp"
#include "quasistatic/stepping/log_time_stepping.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr std::array both_loads = {Load::shear, Load::bulk};
constexpr PhaseIndex of_matrix = 0, of_filler = 1, of_coating = 2;
const std::vector<VaryingPhase> matrix_and_coating = {{of_matrix, "matrix"}, {of_coating, "coating"}};

/// A binder that relaxes from 1 us to 100 us, a coating that relaxes from 0.3 us to 1 ms in shear and in volume, and an
/// elastic filler.
std::vector<Material> three_materials() {
  return {{"binder", 1480.0, PronySeries(3.6e9), PronySeries(1e6, {{1e-6, 300e6}, {1e-5, 50e6}, {1e-4, 5e6}})},
          {"filler", 1850.0, PronySeries(13.4e9), PronySeries(5.84e9)},
          {"interphase", 1480.0, PronySeries(1e9, {{3e-6, 1e9}, {3e-4, 5e8}}),
           PronySeries(2e7, {{3e-7, 2e9}, {3e-5, 4e8}, {1e-3, 1e8}})}};
}

/// A coated disc in a square.
PhaseAt coated_disc(const Vector<2>& position) {
  const double radius = std::hypot(position[0] - 0.5, position[1] - 0.5);
  if (radius < 0.3) return {of_filler};
  return {radius < 0.38 ? of_coating : of_matrix};
}

QuasistaticProblem<2> coated(int n, Boundary boundary, Mixing mixing) {
  const Grid<2> grid = {{n, n}, 1.0 / n};
  return {.discretisation =
              mixing == Mixing::points ? discretise<2>(grid, coated_disc) : discretise_mixed(grid, coated_disc, 3),
          .materials = three_materials(),
          .boundary = boundary};
}

std::vector<Material> of_varying(const QuasistaticProblem<2>& problem, const std::vector<VaryingPhase>& varying) {
  std::vector<Material> chosen;
  chosen.reserve(varying.size());
  for (const auto& [index, name] : varying) chosen.push_back(problem.materials[index]);
  return chosen;
}

TrainingPath joint_path(const QuasistaticProblem<2>& problem, const std::vector<VaryingPhase>& varying,
                        const TimeWindow& window = test::relaxation_window) {
  TrainingPath path = {varying, {}};
  for (const auto& point : carson_path(of_varying(problem, varying), window)) path.points.push_back(point.moduli);
  return path;
}

using BoundaryAndMixing = std::tuple<Boundary, Mixing>;

class SeveralPhases : public testing::TestWithParam<BoundaryAndMixing> {
 protected:
  [[nodiscard]] static QuasistaticProblem<2> problem(int n = 16) {
    const auto [boundary, mixing] = GetParam();
    return coated(n, boundary, mixing);
  }
};

INSTANTIATE_TEST_SUITE_P(Cases, SeveralPhases,
                         testing::Combine(testing::ValuesIn(test::boundaries),
                                          testing::Values(Mixing::points, Mixing::series)),
                         [](const auto& info) {
                           return std::string(name_of(std::get<0>(info.param))) + "_" +
                                  std::string(name_of(std::get<1>(info.param)));
                         });

TEST_P(SeveralPhases, AgreeWithSteppingThroughTime) {
  const auto composite = problem(12);
  const auto times = test::logarithmic(1e-3 * test::relaxation_window.begin, test::relaxation_window.end, 120);
  const std::vector kept = {times[360], times.back()};
  const auto stepped = run_log_time_stepping(composite, both_loads, times, {}, kept);
  const auto sampled =
      sample_responses(composite, both_loads, joint_path(composite, matrix_and_coating), {.tolerance = 1e-9});
  const auto of_phases = of_varying(composite, matrix_and_coating);
  for (std::size_t l = 0; l < both_loads.size(); ++l) {
    const auto compliance = creep_compliance(sampled.responses[l], of_phases);
    const auto modulus = relaxation_modulus(compliance);
    for (std::size_t i = 0; i < times.size(); ++i) {
      if (times[i] < test::relaxation_window.begin) continue;
      const bool creeps = composite.boundary == Boundary::traction;
      const double value = creeps ? compliance.at(times[i]) : modulus.at(times[i]);
      const double difference = std::abs(value / stepped.responses[l].values[i] - 1.0);
      EXPECT_LT(difference, 1e-3) << times[i];
      EXPECT_LT(difference, 2.0 * stepped.responses[l].error_estimates[i] + 1e-4) << times[i];
    }
  }
  for (const auto& [time, exact] : stepped.fields) {
    const auto fields = sampled.fields(0, of_phases, time);
    double largest = 0.0, furthest = 0.0;
    for (std::size_t p = 0; p < exact.stress.size(); ++p) {
      for (std::size_t k = 0; k < exact.stress[p].size(); ++k) {
        largest = std::max(largest, std::abs(exact.stress[p][k]));
        furthest = std::max(furthest, std::abs(exact.stress[p][k] - fields.stress[p][k]));
      }
    }
    EXPECT_LT(furthest, 3e-3 * largest) << time;
  }
}

// The stiffness is affine in the moduli of all phases, so a projection has more energy than the composite, on the path
// of the training set and beside it.
TEST_P(SeveralPhases, AreNeverSofterThanTheComposite) {
  auto composite = problem(12);
  const auto path = joint_path(composite, matrix_and_coating);
  const auto responses = sample_responses(composite, both_loads, path, {.tolerance = 1e-3}).responses;
  for (const double factor : {1.0, 0.2, 5.0}) {
    for (std::size_t i = 0; i < path.points.size(); i += 12) {
      auto moduli = path.points[i];
      moduli[1].shear *= factor;
      const auto exact =
          sample_responses(composite, both_loads, {.phases = matrix_and_coating, .points = {moduli}}).responses;
      for (std::size_t l = 0; l < both_loads.size(); ++l) {
        EXPECT_GT(responses[l].modulus(moduli) / exact[l].modulus(moduli), 1.0 - 1e-8) << factor;
      }
    }
  }
  for (const auto& point : path.points) {
    EXPECT_LT(responses[0].error_estimate(point), 1e-3);
  }
}

TEST_P(SeveralPhases, HaveTheCarsonTransformOfTheElasticResponse) {
  const auto composite = problem(12);
  const auto response =
      sample_responses(composite, std::array{Load::shear}, joint_path(composite, matrix_and_coating)).responses[0];
  const auto of_phases = of_varying(composite, matrix_and_coating);
  const auto compliance = creep_compliance(response, of_phases);
  for (const double s : test::logarithmic(1e-2, 1e12, 1)) {
    double transform = compliance.instantaneous();
    for (const auto& [time, strength] : compliance.terms()) transform += strength / (1.0 + s * time);
    const std::vector moduli = {carson_moduli(of_phases[0], s), carson_moduli(of_phases[1], s)};
    EXPECT_NEAR(transform * response.modulus(moduli), 1.0, 1e-9) << s;
  }
}

/// A coated disc in a square whose left half has a separate phase for the matrix.
PhaseAt coated_disc_in_two_halves(const Vector<2>& position) {
  constexpr PhaseIndex left = 3;
  const auto found = coated_disc(position);
  return found.phase == of_matrix && position[0] < 0.5 ? PhaseAt{left} : found;
}

TEST(SeveralPhasesOfOneMaterial, AreOnePhase) {
  auto composite = coated(16, Boundary::displacement, Mixing::points);
  const auto one = sample_responses(composite, both_loads, joint_path(composite, matrix_and_coating)).responses;
  composite.discretisation = discretise<2>(composite.discretisation.grid(), coated_disc_in_two_halves);
  composite.materials.push_back(composite.materials[of_matrix]);
  const std::vector<VaryingPhase> all = {{of_matrix, "matrix"}, {of_coating, "coating"}, {3, "left"}};
  const auto two = sample_responses(composite, both_loads, joint_path(composite, all)).responses;
  for (std::size_t l = 0; l < both_loads.size(); ++l) {
    const auto modulus_of_one = relaxation_modulus(creep_compliance(one[l], of_varying(composite, matrix_and_coating)));
    const auto modulus_of_two = relaxation_modulus(creep_compliance(two[l], of_varying(composite, all)));
    EXPECT_EQ(one[l].snapshots.size(), two[l].snapshots.size());
    for (const double time : test::logarithmic(1e-7, 1e-3, 4)) {
      EXPECT_NEAR(modulus_of_two.at(time) / modulus_of_one.at(time), 1.0, 1e-9) << time;
    }
  }
}

/// Layers of the three phases, two columns of cells each.
QuasistaticProblem<2> three_layers(std::vector<Material> of_layers, Boundary boundary) {
  Discretisation<2> discretisation(Grid<2>{{6, 6}, 1.0});
  discretisation.label([](const Vector<2>& position) { return static_cast<PhaseIndex>(position[0] / 2.0); });
  return {.discretisation = std::move(discretisation), .materials = std::move(of_layers), .boundary = boundary};
}

// Layers sheared along each other have one shear stress: their creep compliances add up.
TEST(LayersOfThreePhases, InShearAddTheirCompliances) {
  for (const auto boundary : {Boundary::traction, Boundary::periodic}) {
    const auto composite = three_layers(three_materials(), boundary);
    const auto response =
        sample_responses(composite, std::array{Load::shear}, joint_path(composite, matrix_and_coating)).responses[0];
    const auto compliance = creep_compliance(response, of_varying(composite, matrix_and_coating));
    for (const double time : test::logarithmic(1e-8, 1e-1, 4)) {
      double sum = 0.0;
      for (const auto& material : composite.materials) sum += creep_compliance(material.shear).at(time) / 3.0;
      EXPECT_NEAR(compliance.at(time) / sum, 1.0, 1e-8) << time;
    }
  }
}

// Phases of one shear modulus have, in any arrangement, 1 / (k + G) = sum of f_i / (k_i + G) with k = K + G/3 (Hill
// 1964); here two of three bulk moduli relax, and the shear modulus does so in all.
TEST(LayersOfThreePhases, OfOneShearModulusHaveTheBulkModulusOfHill) {
  const PronySeries shear(1e7, {{1e-6, 5e8}, {2e-4, 1e8}});
  const std::vector<Material> of_layers = {{"a", 1.0, PronySeries(1e8, {{1e-5, 3e9}}), shear},
                                           {"b", 1.0, PronySeries(5e9), shear},
                                           {"c", 1.0, PronySeries(2e7, {{1e-6, 1e9}, {1e-3, 2e8}}), shear}};
  const auto composite = three_layers(of_layers, Boundary::periodic);
  const std::vector<VaryingPhase> varying = {{0, "matrix"}, {1, "b"}, {2, "c"}};
  const auto response =
      sample_responses(composite, std::array{Load::bulk}, joint_path(composite, varying)).responses[0];
  const auto modulus = relaxation_modulus(creep_compliance(response, of_layers));
  std::vector<RetardationTerm> terms;
  double instantaneous = 0.0;
  for (const auto& material : of_layers) {
    // k + G = K + 4 G / 3
    const auto creep = creep_compliance(plane_strain_bulk_modulus({"", 1.0, material.bulk, shear.scaled(4.0)}));
    instantaneous += creep.instantaneous() / 3.0;
    for (const auto& [time, strength] : creep.terms()) terms.push_back({time, strength / 3.0});
  }
  const auto expected = relaxation_modulus(CreepCompliance(instantaneous, terms));
  for (const double time : test::logarithmic(1e-8, 1e-1, 4)) {
    EXPECT_NEAR((modulus.at(time) + shear.at(time)) / expected.at(time), 1.0, 1e-7) << time;
  }
}

// A coating that is elastic in the study may vary, too: another elastic coating is close enough to be covered.
TEST(AnElasticPhaseThatVaries, IsAnsweredWithOtherMaterialsThatAreCovered) {
  auto composite = coated(16, Boundary::periodic, Mixing::points);
  composite.materials[of_coating] = {"interphase", 1000.0, PronySeries(2e9), PronySeries(4e8)};
  const auto response =
      sample_responses(composite, std::array{Load::shear}, joint_path(composite, matrix_and_coating)).responses[0];
  composite.materials[of_coating].shear = PronySeries(4.1e8);
  const auto direct =
      sample_responses(composite, std::array{Load::shear}, joint_path(composite, {{of_matrix, "matrix"}})).responses[0];
  auto of_phases = of_varying(composite, matrix_and_coating);
  const auto expected = relaxation_modulus(creep_compliance(direct, of_phases[0]));
  const auto found = relaxation_modulus(creep_compliance(response, of_phases));
  EXPECT_TRUE(coverage(response, of_phases, test::relaxation_window).is_whole());
  EXPECT_LT(largest_error(response, of_phases, test::relaxation_window), 1e-3);
  for (const double time : test::logarithmic(1e-7, 1e-3, 2)) {
    EXPECT_NEAR(found.at(time) / expected.at(time), 1.0, 1e-4) << time;
  }
  of_phases[1].shear = PronySeries(1e9);
  const auto refused = coverage(response, of_phases, test::relaxation_window);
  EXPECT_FALSE(refused.is_whole());
  EXPECT_TRUE(refused.phases[0].is_whole());
  EXPECT_EQ(refused.phases[1].phase, "coating");
  EXPECT_FALSE(refused.phases[1].is_shear_covered);
  EXPECT_FALSE(refused.times);
}

// The poles belong to the single shear modulus that relaxes, of whichever phase; with a slight relaxation of another
// modulus the network gives the same ones.
TEST(SeveralPhasesOfWhichOneRelaxes, HaveTheSameSpectrumInTwoWays) {
  const auto composite = coated(12, Boundary::traction, Mixing::series);
  const auto response =
      sample_responses(composite, std::array{Load::shear}, joint_path(composite, matrix_and_coating)).responses[0];
  auto of_phases = of_varying(composite, matrix_and_coating);
  of_phases[0].shear = PronySeries(3e7);
  of_phases[1].bulk = PronySeries(2e9);
  const auto poles = creep_compliance(response, of_phases);
  of_phases[0].shear = PronySeries(3e7 * (1.0 - 1e-9), {{1e-5, 3e7 * 1e-9}});
  const auto network = creep_compliance(response, of_phases);
  for (const double time : test::logarithmic(1e-12, 1e2, 2)) {
    EXPECT_NEAR(network.at(time) / poles.at(time), 1.0, 1e-7) << time;
  }
}

// A run that is interrupted before every solution gives results that are bitwise identical to those of one that is not.
TEST(SamplingOfSeveralPhases, IsResumedWithTheSameBits) {
  const auto composite = coated(10, Boundary::traction, Mixing::series);
  const auto path = joint_path(composite, matrix_and_coating);
  const auto whole = sample_responses(composite, both_loads, path).responses;
  const test::TemporaryDirectory directory;
  std::vector<ReducedResponse> resumed;
  int interruptions = 0;
  while (resumed.empty()) {
    Checkpoint checkpoint(directory.path() / "sampling.checkpoint.h5", {"hash", "version"},
                          {.interval = 0.0, .stop = [&] { return interruptions < 5; }});
    EXPECT_TRUE(checkpoint.look_for_earlier().empty());
    try {
      resumed = sample_responses(composite, both_loads, path, {}, {}, &checkpoint).responses;
    } catch (const Interrupted&) {
      ++interruptions;
    }
  }
  EXPECT_EQ(interruptions, 5);
  for (std::size_t l = 0; l < both_loads.size(); ++l) {
    ASSERT_EQ(resumed[l].snapshots.size(), whole[l].snapshots.size());
    EXPECT_EQ(resumed[l].snapshots.back().moduli[1].shear, whole[l].snapshots.back().moduli[1].shear);
    EXPECT_EQ(resumed[l].constant, whole[l].constant);
    for (std::size_t i = 0; i < whole[l].parts.size(); ++i) {
      EXPECT_EQ(resumed[l].parts[i].parameter, whole[l].parts[i].parameter);
      EXPECT_EQ(resumed[l].parts[i].stiffness, whole[l].parts[i].stiffness);
    }
    EXPECT_EQ(resumed[l].residual_products, whole[l].residual_products);
  }
}

TEST(SamplingOfSeveralPhases, RefusesPhasesThatAreMissingTwiceThereOrWithoutMaterial) {
  const auto composite = coated(6, Boundary::periodic, Mixing::points);
  const auto message_with = [&](const std::vector<VaryingPhase>& varying) {
    const TrainingPath path = {varying, {std::vector<Moduli>(varying.size(), {.bulk = 1e9, .shear = 1e9})}};
    return test::message_of<InputError>([&] { static_cast<void>(sample_responses(composite, both_loads, path)); });
  };
  EXPECT_EQ(message_with({{of_matrix, "matrix"}}),
            "reduced basis: interphase relaxes: expected its phase among those whose moduli vary, or stepping through "
            "time");
  EXPECT_THAT(message_with({}), AllOf(HasSubstr("expected at least one phase whose moduli vary"),
                                      HasSubstr("binder relaxes"), HasSubstr("interphase relaxes")));
  EXPECT_EQ(message_with({{of_matrix, "matrix"}, {of_coating, "coating"}, {of_filler, "coating"}}),
            "reduced basis: the phase coating, number 1, is given twice");
  EXPECT_THAT(message_with({{of_matrix, "matrix"}, {of_coating, "coating"}, {of_matrix, "again"}, {7, "shell"}}),
              AllOf(HasSubstr("the phase again, number 0, is given twice"),
                    HasSubstr("the phase shell has number 7, but there are materials for 3 phases")));
  const TrainingPath incomplete = {matrix_and_coating, {{{.bulk = 1e9, .shear = 1e9}}}};
  EXPECT_EQ(
      test::message_of<InputError>([&] { static_cast<void>(sample_responses(composite, both_loads, incomplete)); }),
      "reduced basis: expected the moduli of 2 phases at each point of the training set, got those of 1");
}

TEST(ResponseOfSeveralPhases, TakesTheMaterialOfEachByItsName) {
  const auto composite = coated(6, Boundary::periodic, Mixing::points);
  const auto response =
      sample_responses(composite, std::array{Load::shear}, joint_path(composite, matrix_and_coating)).responses[0];
  const auto& binder = composite.materials[of_matrix];
  const auto& interphase = composite.materials[of_coating];
  EXPECT_EQ(response.phases(), (std::vector<std::string>{"matrix", "coating"}));
  EXPECT_EQ(response.materials({{"coating", interphase}, {"matrix", binder}}), (std::vector{binder, interphase}));
  EXPECT_EQ(test::message_of<InputError>([&] {
              static_cast<void>(response.materials({{"matrix", binder}, {"coatnig", interphase}}));
            }),
            "reduced response: the phase coating has no material; interphase is given for coatnig, expected one of the "
            "phases matrix, coating");
  EXPECT_THROW(static_cast<void>(creep_compliance(response, binder)), InputError);
  EXPECT_THROW(static_cast<void>(response.parameters(std::vector<Moduli>(3))), InputError);
  EXPECT_THROW(static_cast<void>(coverage(response, std::array{binder}, {1e-6, 1e-3})), InputError);
  EXPECT_THROW(
      static_cast<void>(sample_responses(composite, std::array{Load::shear}, joint_path(composite, matrix_and_coating))
                            .fields(0, std::array{binder}, 1e-5)),
      InputError);
}

}  // namespace
}  // namespace breccia
