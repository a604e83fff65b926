#include "quasistatic/reduced/sampled_moduli.hpp"

#include <array>

#include <gtest/gtest.h>

#include "quasistatic/composites.hpp"
#include "quasistatic/reduced/carson_path.hpp"
#include "quasistatic/reduced/sampling.hpp"

namespace breccia {
namespace {

/// A response that has only the range of its snapshots: 1 to 100 MPa in shear, 2 GPa in bulk.
ReducedResponse response_over_two_decades() {
  ReducedResponse response;
  response.parts = matrix_parts({}, {});
  response.snapshots = {{.moduli = {{.bulk = 2e9, .shear = 1e7}}},
                        {.moduli = {{.bulk = 2e9, .shear = 1e8}}},
                        {.moduli = {{.bulk = 2e9, .shear = 1e6}}}};
  return response;
}

/// A material whose Carson modulus at s = 1/t is G / (1 + t / tau).
Material maxwell(double modulus, double relaxation_time) {
  return {"m", 1000.0, PronySeries(2e9), PronySeries(0.0, {{relaxation_time, modulus}})};
}

TEST(Coverage, IsWholeWithinTheSnapshots) {
  const auto found = coverage(response_over_two_decades(), std::array{maxwell(5e7, 1.0)}, {1e-3, 1e1});
  EXPECT_TRUE(found.is_whole());
  ASSERT_TRUE(found.times);
  EXPECT_EQ(found.times->begin, 1e-3);
  EXPECT_EQ(found.times->end, 1e1);
}

TEST(Coverage, TellsTheTimesAtWhichTheMatrixIsWithinTheSnapshots) {
  // 1 GPa / (1 + t) is 100 MPa at 9 s and 1 MPa at 999 s; the range reaches 5 % further.
  const auto found = coverage(response_over_two_decades(), std::array{maxwell(1e9, 1.0)}, {1e-3, 1e6});
  EXPECT_FALSE(found.phases[0].is_shear_covered);
  EXPECT_TRUE(found.phases[0].is_bulk_covered);
  ASSERT_TRUE(found.times);
  EXPECT_LE(found.times->begin, 9.0);
  EXPECT_GT(found.times->begin, 8.4);
  EXPECT_GE(found.times->end, 999.0);
  EXPECT_LT(found.times->end, 1053.0);
  EXPECT_NEAR(found.phases[0].shown.most.shear / 1e9, 1.0, 1e-2);
  EXPECT_NEAR(found.phases[0].shown.least.shear / 1e3, 1.0, 1e-2);
  EXPECT_NEAR(found.phases[0].sampled.most.shear, 1.05e8, 1.0);
}

TEST(Coverage, OfWhatIsAlwaysTooStiffIsNone) {
  const auto found = coverage(response_over_two_decades(), std::array{maxwell(1e12, 1.0)}, {1e-3, 1e1});
  EXPECT_FALSE(found.is_whole());
  EXPECT_FALSE(found.times);
}

TEST(Coverage, AsksForTheBulkModulusToo) {
  auto matrix = maxwell(5e7, 1.0);
  matrix.bulk = PronySeries(2.1e9);
  EXPECT_TRUE(coverage(response_over_two_decades(), std::array{matrix}, {1e-3, 1e1}).is_whole());
  matrix.bulk = PronySeries(3e9);
  const auto found = coverage(response_over_two_decades(), std::array{matrix}, {1e-3, 1e1});
  EXPECT_TRUE(found.phases[0].is_shear_covered);
  EXPECT_FALSE(found.phases[0].is_bulk_covered);
  EXPECT_FALSE(found.times);
}

TEST(Coverage, TheErrorOfAnotherMatrixIsThatOfTheTolerance) {
  const auto problem = test::random_composite(20, 6, Boundary::periodic);
  auto matrix = problem.materials.front();
  const TimeWindow window = {1e-7, 1e-3};
  const auto path = relaxation_path(matrix, window);
  const auto response = sample_responses(problem, std::array{Load::shear}, matrix_path(0, path)).responses.front();
  EXPECT_LT(largest_error(response, std::array{matrix}, window), 1e-5);
  matrix.shear = PronySeries(0.4e6, {{2e-6, 200e6}});
  EXPECT_TRUE(coverage(response, std::array{matrix}, window).is_whole());
  EXPECT_LT(largest_error(response, std::array{matrix}, window), 1e-5);
}

}  // namespace
}  // namespace breccia
