// Tests of superposition of loads, of reciprocity of the work, and of the independence of the number of threads.

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "properties/random_composite.hpp"
#include "quasistatic/stepping/log_time_stepping.hpp"

namespace breccia {
namespace {

using test::Composite;
using test::FillerKind;
using test::random_composite;

std::vector<Averages<2>> averages_under(const Composite& composite, Boundary boundary, Formulation formulation,
                                        const Strain<2>& load) {
  DynamicProblem<2> problem{.discretisation = discretise(composite.box, test::cells, test::matrix, test::filler),
                            .materials = composite.materials,
                            .volumetric = composite.volumetric,
                            .boundary = boundary,
                            .load = load,
                            .traction = {.xx = 2.0 * load.xx, .yy = 2.0 * load.yy, .xy = 2.0 * load.xy}};
  problem.time_step = 0.9 * stable_time_step(problem.discretisation, problem.materials, problem.volumetric, 1.0);
  problem.ramp = StrainRamp(40.0 * problem.time_step);
  std::vector<Averages<2>> averages;
  make_dynamic_solver(formulation, problem, 1)->advance(200, averages);
  return averages;
}

double largest_part(const Stress<2>& stress) {
  return std::max({std::abs(stress.xx), std::abs(stress.yy), std::abs(stress.xy)});
}

TEST(RandomComposites, AnswerTwoLoadsByTheSumOfTheAnswers) {
  const Strain<2> shear = unit_strain<2>(Load::shear), bulk = unit_strain<2>(Load::bulk);
  const Strain<2> both = {shear.xx + bulk.xx, shear.yy + bulk.yy, shear.xy + bulk.xy};
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const auto composite = random_composite(seed, FillerKind::relaxing);
    for (const auto boundary : test::boundaries) {
      for (const auto formulation : {Formulation::total_lagrangian, Formulation::classical}) {
        const auto first = averages_under(composite, boundary, formulation, shear);
        const auto second = averages_under(composite, boundary, formulation, bulk);
        const auto sum = averages_under(composite, boundary, formulation, both);
        // The points of the classical formulation move, by a millionth of the strain.
        const double tolerance = formulation == Formulation::classical ? 1e-4 : 1e-11;
        double scale = 0.0, largest = 0.0;
        for (std::size_t i = 0; i < sum.size(); ++i) {
          const auto &a = first[i].stress, &b = second[i].stress, &c = sum[i].stress;
          scale = std::max(scale, largest_part(c));
          largest = std::max(largest, largest_part({a.xx + b.xx - c.xx, a.yy + b.yy - c.yy, a.xy + b.xy - c.xy}));
        }
        EXPECT_GT(scale, 0.0);
        EXPECT_LT(largest, tolerance * scale) << "seed " << seed << ", boundary " << static_cast<int>(boundary);
      }
    }
  }
}

/// Mean over the points of stress : unit_strain(load) [Pa].
double mean_work(const PointFields<2>& fields, Load load) {
  double work = 0.0;
  for (const auto& [xx, yy, zz, xy] : fields.stress) work += modulus_of<2>(load, {xx, yy, xy});
  return work / static_cast<double>(fields.stress.size());
}

/// The composite with its unrelaxed moduli, right after a load.
Composite unrelaxed(Composite composite) {
  for (auto& material : composite.materials) {
    material.bulk = PronySeries(material.bulk.unrelaxed());
    material.shear = PronySeries(material.shear.unrelaxed());
  }
  return composite;
}

/// Relative difference between the works of the stress under each of two loads on the strain under the other load.
double mutual_work_difference(const Composite& composite, Boundary boundary) {
  const QuasistaticProblem<2> problem{
      .discretisation = discretise(composite.box, test::cells, test::matrix, test::filler),
      .materials = composite.materials,
      .volumetric = composite.volumetric,
      .boundary = boundary};
  const auto times = logarithmic_times(test::window, 40);
  const auto fields_under = [&](Load load) {
    return run_log_time_stepping(problem, std::array{load}, times, {}, std::array{test::window.end})
        .fields.at(0)
        .fields;
  };
  const auto shear = fields_under(Load::shear), bulk = fields_under(Load::bulk);
  return std::abs(mean_work(shear, Load::bulk) - mean_work(bulk, Load::shear)) / mean_work(bulk, Load::bulk);
}

TEST(RandomComposites, DoMutualWork) {
  // By the theorem of Betti and Maxwell, the work of the stress of one load on the strain of another is mutual. Time
  // steps make no difference for a composite that does not relax, and little for one that does.
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    const auto composite = random_composite(seed, FillerKind::relaxing);
    for (const auto boundary : {Boundary::displacement, Boundary::periodic}) {
      EXPECT_LT(mutual_work_difference(unrelaxed(composite), boundary), 1e-8) << "seed " << seed;
      EXPECT_LT(mutual_work_difference(composite, boundary), 1e-4) << "seed " << seed;
    }
  }
}

TEST(RandomComposites, HaveTheSameBitsForAnyNumberOfThreads) {
  const auto composite = random_composite(2);
  for (const auto boundary : test::boundaries) {
    auto test = dynamic_test(composite, boundary);
    const auto curve = run_dynamic_test(test).curve;
    for (const int threads : {2, 3, 5}) {
      test.threads = threads;
      EXPECT_EQ(run_dynamic_test(test).curve, curve) << threads << " threads";
    }
    auto slow = quasistatic_test(composite, boundary);
    slow.options.linear.method = LinearMethod::iterative;
    slow.options.linear.threads = 1;
    const auto series = run_quasistatic_test(slow).responses[0].series;
    for (const int threads : {2, 3}) {
      slow.options.linear.threads = threads;
      EXPECT_EQ(run_quasistatic_test(slow).responses[0].series, series) << threads << " threads";
    }
  }
}

}  // namespace
}  // namespace breccia
