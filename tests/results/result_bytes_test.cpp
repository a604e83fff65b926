#include "results/result_bytes.hpp"

#include <cmath>
#include <limits>
#include <variant>

#include <gtest/gtest.h>

#include "breccia/error.hpp"

namespace breccia {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// A stage with all data that its bytes hold; the numbers have more digits than those of a table.
StageFindings findings() {
  TestResult creep{.id = {Load::bulk, Boundary::traction, Method::dynamic, TestGrid(24)}};
  creep.modulus = {{1.0 / 3.0, 2.0e6 / 7.0}, {1.0, 1.0e-300}};
  creep.compliance = {{1.0 / 3.0, 7.0 / 2.0e6}};
  creep.series = PronySeries(1.0 / 7.0, {{3.0, 2.0 / 3.0}});
  creep.seconds = 0.1;
  TestResult limit{.id = {.grid = TestGrid::extrapolated()}, .error_estimate = 1e-4, .half_bands = {0.1, infinite}};
  StageFindings stage;
  stage.name = "A";
  stage.cells = 24;
  stage.dimensions = 3;
  stage.points = 110592;
  stage.point_fraction = 0.1 + 0.2;
  stage.tests = {creep, limit};
  stage.materials = {
      {Boundary::traction,
       Method::dynamic,
       {{"A", 1500.0, PronySeries::difference(PronySeries(3.0), creep.series), creep.series}, {0.1, 10.0}, 1e-3, 0.0}}};
  stage.comparisons = {{"measured \xc2\xb5", limit.id, {{1.0, 2.0, 3.0}}}};
  stage.accuracy = {"grid: one grid, error up to about 4 % by a rule", {}, {0.04, SampleKind::grains, 12.5}};
  stage.tests.back().errors = {{0.1, {}, 0.0, 0.2}};
  stage.warnings = {"doubt"};
  return stage;
}

TEST(ResultBytes, GiveTheSameBits) {
  const auto stage = findings(), found = stage_from_bytes(bytes_of(stage));
  EXPECT_EQ(bytes_of(found), bytes_of(stage));
  EXPECT_EQ(found.dimensions, 3);
  EXPECT_EQ(found.points, stage.points);
  EXPECT_EQ(found.point_fraction, stage.point_fraction);
  ASSERT_EQ(found.tests.size(), 2U);
  EXPECT_EQ(found.tests[0].id, stage.tests[0].id);
  EXPECT_EQ(found.tests[0].modulus, stage.tests[0].modulus);
  EXPECT_EQ(found.tests[0].compliance, stage.tests[0].compliance);
  EXPECT_EQ(found.tests[0].series, stage.tests[0].series);
  EXPECT_EQ(found.tests[0].seconds, 0.1);
  EXPECT_TRUE(std::isnan(found.tests[0].error_estimate));
  EXPECT_EQ(found.tests[1].half_bands, stage.tests[1].half_bands);
  EXPECT_FALSE(found.tests[1].seconds);
  EXPECT_EQ(found.materials.at(0).result.material, stage.materials[0].result.material);
  EXPECT_EQ(found.comparisons.at(0).measurement, stage.comparisons[0].measurement);
  EXPECT_EQ(found.comparisons.at(0).best()->ratio(), 2.0 / 3.0);
  EXPECT_EQ(found.accuracy.summary, stage.accuracy.summary);
  EXPECT_FALSE(found.accuracy.grid_error);
  EXPECT_EQ(found.accuracy.rules.one_grid, 0.04);
  EXPECT_EQ(found.accuracy.rules.sample, SampleKind::grains);
  EXPECT_EQ(found.accuracy.rules.effective_particles, 12.5);
  EXPECT_EQ(found.tests[1].errors.at(0).matrix, 0.2);
  EXPECT_FALSE(found.tests[1].errors[0].sample);
  EXPECT_EQ(found.warnings, stage.warnings);
}

TEST(ResultBytes, HoldTheShiftsOfMaterials) {
  StudyContent content{.title = "t", .times = {0.1, 10.0}};
  content.materials = {{{"binder", 1e3, PronySeries(2e9), PronySeries(1.0, {{1.0, 1.0}})},
                        TemperatureShift{WilliamsLandelFerry{6.5, 120.0, 293.15}, 313.15}}};
  content.stages = {{"A", "binder", 2, {{"glass", 0.3, 0.5}}}};
  const auto found = content_from_bytes(bytes_of(content));
  EXPECT_EQ(found.times.end, 10.0);
  EXPECT_EQ(found.materials.at(0).material, content.materials[0].material);
  EXPECT_EQ(found.materials.at(0).shift.value().temperature, 313.15);
  EXPECT_EQ(std::get<WilliamsLandelFerry>(found.materials[0].shift->law).c2, 120.0);
  EXPECT_EQ(found.stages.at(0).shares.at(0).mass_fraction, 0.5);
}

TEST(ResultBytes, AreRefusedWhereTheyAreCutOrOfSomethingElse) {
  const auto bytes = bytes_of(findings());
  EXPECT_THROW(static_cast<void>(stage_from_bytes(bytes.substr(0, bytes.size() / 2))), FileError);
  EXPECT_THROW(static_cast<void>(test_from_bytes(bytes)), FileError);
  EXPECT_THROW(static_cast<void>(content_from_bytes("")), FileError);
}

}  // namespace
}  // namespace breccia
