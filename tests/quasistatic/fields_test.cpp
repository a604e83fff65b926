#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "breccia/viscoelasticity/interconversion.hpp"

#include "discretisation/mixed_cells.hpp"
#include "quasistatic/composites.hpp"
#include "quasistatic/mean_fields.hpp"
#include "quasistatic/reduced/carson_path.hpp"
#include "quasistatic/reduced/sampling.hpp"
#include "quasistatic/stepping/log_time_stepping.hpp"

namespace breccia {
namespace {

constexpr std::array field_times = {1e-7, 1e-5, 1e-3};

SampledResponses<2> sampled(const QuasistaticProblem<2>& problem, Load load) {
  return sample_responses(problem, std::array{load},
                          matrix_path(0, carson_path(problem.materials.front(), test::relaxation_window)));
}

/// Composites whose matrix relaxes in shear alone, and in volume too.
std::vector<QuasistaticProblem<2>> composites(Boundary boundary) {
  std::vector problems = {test::random_composite(20, 1, boundary), test::random_composite(20, 1, boundary),
                          test::model_composite(16, Volumetric::standard, boundary)};
  problems[1].materials.front().bulk = PronySeries(1e8, {{3e-7, 2e9}, {2e-5, 1e9}});
  problems[2].materials.front().shear = PronySeries(0.0, {{1e-5, 0.5e6}, {1e-2, 1e3}});
  return problems;
}

TEST(Fields, AverageToTheCurve) {
  for (const auto boundary : test::boundaries) {
    for (const auto& problem : composites(boundary)) {
      for (const auto load : {Load::shear, Load::diagonal_shear, Load::bulk}) {
        const auto found = sampled(problem, load);
        const auto& matrix = problem.materials.front();
        const auto compliance = creep_compliance(found.responses[0], matrix);
        for (const double time : field_times) {
          const auto fields = found.fields(0, std::array{matrix}, time);
          const double stress = modulus_of(load, test::mean_stress(fields)),
                       strain = compliance_of(load, test::mean_strain(fields));
          if (boundary == Boundary::traction) {
            EXPECT_NEAR(stress, 1.0, 1e-9) << time;
            EXPECT_NEAR(strain / compliance.at(time), 1.0, 1e-9) << time;
          } else {
            EXPECT_NEAR(strain, 1.0, 1e-9) << time;
            EXPECT_NEAR(stress / relaxation_modulus(compliance).at(time), 1.0, 1e-9) << time;
          }
        }
      }
    }
  }
}

/// Largest difference of two lists of components over the largest component.
template <std::size_t n>
double difference(const std::vector<std::array<double, n>>& one, const std::vector<std::array<double, n>>& other) {
  double largest = 0.0, furthest = 0.0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    for (std::size_t k = 0; k < n; ++k) {
      largest = std::max(largest, std::abs(one[i][k]));
      furthest = std::max(furthest, std::abs(one[i][k] - other[i][k]));
    }
  }
  return furthest / largest;
}

TEST(Fields, OfTheReducedBasisAreThoseOfStepping) {
  for (const auto boundary : test::boundaries) {
    for (const auto& problem : composites(boundary)) {
      const auto times = test::logarithmic(1e-3 * test::relaxation_window.begin, test::relaxation_window.end, 60);
      const std::vector kept = {times[180], times.back()};
      const auto stepped = run_log_time_stepping(problem, std::array{Load::shear}, times, {}, kept);
      ASSERT_EQ(stepped.fields.size(), kept.size());
      const auto found = sample_responses(
          problem, std::array{Load::shear},
          matrix_path(0, carson_path(problem.materials.front(), test::relaxation_window)), {.tolerance = 1e-9});
      for (const auto& [time, exact] : stepped.fields) {
        const auto fields = found.fields(0, std::span(problem.materials).first(1), time);
        EXPECT_LT(difference(exact.displacement, fields.displacement), 3e-3) << time;
        EXPECT_LT(difference(exact.strain, fields.strain), 3e-3) << time;
        EXPECT_LT(difference(exact.stress, fields.stress), 3e-3) << time;
      }
    }
  }
}

// Under a held shear strain the stress of a homogeneous box relaxes as its matrix does, everywhere; under a traction
// the strain creeps.
TEST(Fields, OfAHomogeneousBoxAreUniform) {
  const Material matrix = {"m", 1000.0, PronySeries(2e6, {{3e-3, 1e6}}), PronySeries(0.1e6, {{1e-3, 0.5e6}})};
  for (const auto boundary : test::boundaries) {
    const auto problem = test::homogeneous(matrix, boundary);
    const auto found =
        sample_responses(problem, std::array{Load::shear}, matrix_path(0, carson_path(matrix, {1e-4, 1.0})));
    for (const double time : {1e-4, 2e-3, 1.0}) {
      const auto fields = found.fields(0, std::array{matrix}, time);
      const bool creeps = boundary == Boundary::traction;
      const double stress = creeps ? 1.0 : matrix.shear.at(time);
      const double strain = creeps ? creep_compliance(matrix.shear).at(time) : 1.0;
      for (std::size_t i = 0; i < fields.stress.size(); ++i) {
        const auto& [xx, yy, zz, xy] = fields.stress[i];
        EXPECT_NEAR(xy / stress, 1.0, 1e-8);
        EXPECT_NEAR(std::max({std::abs(xx), std::abs(yy), std::abs(zz)}) / stress, 0.0, 1e-8);
        EXPECT_NEAR(2.0 * fields.strain[i][2] / strain, 1.0, 1e-8);
      }
    }
  }
}

/// Two spheres in a cube, with mixed cells or with points, whose matrix relaxes in shear and in volume.
QuasistaticProblem<3> relaxing_spheres(Mixing mixing, Boundary boundary) {
  Microstructure<3> box = {1.0, Walls::hard, {{{0.31, 0.36, 0.42}, 0.5}, {{0.72, 0.66, 0.61}, 0.4}}};
  constexpr std::array<PhaseIndex, 2> spheres = {1, 1};
  constexpr int cells = 6;
  QuasistaticProblem<3> problem = {
      .discretisation =
          mixing == Mixing::series ? discretise_mixed(box, cells, 0, spheres, 2) : discretise(box, cells, 0, 1),
      .materials = {{"matrix", 1.0, PronySeries(1e8, {{3e-7, 2e9}}), PronySeries(1e6, {{1e-6, 80e6}, {1e-4, 4e6}})},
                    {"sphere", 1.0, PronySeries(13.4e9), PronySeries(5.84e9)}},
      .boundary = boundary};
  problem.linear.method = LinearMethod::direct;
  return problem;
}

/// Mean of a tensor over the cells.
template <class Tensor>
Tensor mean_tensor(const std::vector<std::array<double, 6>>& tensors) {
  Tensor mean;
  for (const auto& tensor : tensors) {
    for (int k = 0; k < 6; ++k) {
      component(mean, k) += tensor[static_cast<std::size_t>(k)] / static_cast<double>(tensors.size());
    }
  }
  return mean;
}

TEST(Fields, OfACubeAverageToTheCurve) {
  for (const auto boundary : test::boundaries) {
    for (const auto mixing : {Mixing::series, Mixing::points}) {
      const auto problem = relaxing_spheres(mixing, boundary);
      const auto& matrix = problem.materials.front();
      for (const auto load : {Load::shear, Load::shear_zx, Load::diagonal_shear_yz, Load::bulk}) {
        const auto found =
            sample_responses(problem, std::array{load}, matrix_path(0, carson_path(matrix, test::relaxation_window)));
        const auto compliance = creep_compliance(found.responses[0], matrix);
        const auto series = relaxation_modulus(compliance);
        for (const double time : field_times) {
          SCOPED_TRACE(testing::Message() << name_of(boundary) << ", " << name_of(load) << ", " << time);
          const auto fields = found.fields(0, std::array{matrix}, time);
          ASSERT_EQ(fields.stress.size(), 216U) << "one value a cell";
          const double stress = modulus_of<3>(load, mean_tensor<Stress<3>>(fields.stress)),
                       strain = compliance_of<3>(load, mean_tensor<Strain<3>>(fields.strain));
          const bool creeps = boundary == Boundary::traction;
          EXPECT_NEAR(creeps ? stress : stress / series.at(time), 1.0, 1e-9);
          EXPECT_NEAR(creeps ? strain / compliance.at(time) : strain, 1.0, 1e-9);
        }
      }
    }
  }
}

TEST(Fields, OfACubeByTheReducedBasisAreThoseOfStepping) {
  const auto problem = relaxing_spheres(Mixing::series, Boundary::periodic);
  const auto times = test::logarithmic(1e-3 * test::relaxation_window.begin, test::relaxation_window.end, 30);
  const std::vector kept = {times.back()};
  const auto stepped = run_log_time_stepping(problem, std::array{Load::shear}, times, {}, kept);
  ASSERT_EQ(stepped.fields.size(), 1U);
  const auto found = sample_responses(problem, std::array{Load::shear},
                                      matrix_path(0, carson_path(problem.materials.front(), test::relaxation_window)),
                                      {.tolerance = 1e-9});
  const auto fields = found.fields(0, std::span(problem.materials).first(1), times.back());
  const auto& exact = stepped.fields.front().fields;
  EXPECT_LT(difference(exact.displacement, fields.displacement), 5e-3);
  EXPECT_LT(difference(exact.strain, fields.strain), 5e-3);
  EXPECT_LT(difference(exact.stress, fields.stress), 5e-3);
}

}  // namespace
}  // namespace breccia
