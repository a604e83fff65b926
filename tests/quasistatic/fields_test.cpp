#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "breccia/quasistatic/carson_path.hpp"
#include "breccia/quasistatic/log_time_stepping.hpp"
#include "breccia/quasistatic/sampling.hpp"
#include "breccia/viscoelasticity/interconversion.hpp"

#include "quasistatic/composites.hpp"

namespace breccia {
namespace {

constexpr std::array field_times = {1e-7, 1e-5, 1e-3};

SampledResponses<2> sampled(const QuasistaticProblem<2>& problem, Load load) {
  return sample_responses(problem, std::array{load},
                          matrix_path(0, carson_path(problem.materials.front(), test::relaxation_window)));
}

Stress<2> mean_stress(const PointFields<2>& fields) {
  Stress<2> mean;
  const auto count = static_cast<double>(fields.stress.size());
  for (const auto& [xx, yy, zz, xy] : fields.stress) {
    mean = {mean.xx + xx / count, mean.yy + yy / count, mean.xy + xy / count};
  }
  return mean;
}

Strain<2> mean_strain(const PointFields<2>& fields) {
  Strain<2> mean;
  const auto count = static_cast<double>(fields.strain.size());
  for (const auto& [xx, yy, xy] : fields.strain) {
    mean = {mean.xx + xx / count, mean.yy + yy / count, mean.xy + xy / count};
  }
  return mean;
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
          const double stress = modulus_of(load, mean_stress(fields)),
                       strain = compliance_of(load, mean_strain(fields));
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

/// Largest difference of two lists of components over the largest of them.
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

}  // namespace
}  // namespace breccia
