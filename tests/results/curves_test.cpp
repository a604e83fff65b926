#include "breccia/results/curves.hpp"

#include <cmath>
#include <filesystem>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "results/hand_made_results.hpp"
#include "results/test_columns.hpp"
#include "tables/csv.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using test::columns_of_tests;
using test::stage_with;
using test::test_with;
using testing::DoubleNear;
using testing::Each;
using testing::ElementsAre;

const TestId on_12_cells{Load::shear, Boundary::displacement, Method::quasistatic, TestGrid(12)};

class WriteCurves : public testing::Test {
 protected:
  [[nodiscard]] CsvTable read(const std::string& name, const std::vector<std::string>& text = columns_of_tests) const {
    return read_csv(directory.path() / name, text);
  }
  [[nodiscard]] bool has(const std::string& name) const { return std::filesystem::exists(directory.path() / name); }

  test::TemporaryDirectory directory;
};

TEST_F(WriteCurves, LeavesARowForEachTimeOfEachTestWithAllItsDigits) {
  const TestId creep{Load::bulk, Boundary::traction, Method::dynamic, TestGrid::extrapolated()};
  const TestId diagonal{Load::diagonal_shear, Boundary::periodic, Method::quasistatic, TestGrid(300)};
  write_curves(directory.path(), {{stage_with("A", {test_with(on_12_cells, {{1e-3, 1.0 / 3.0}, {0.1, 2e9 / 7.0}})}),
                                   stage_with("B", {test_with(creep, {{1e-300, 5.0}}), test_with(diagonal, {{2, 4}})})},
                                  {}});
  const auto table = read("curves.csv");
  EXPECT_THAT(table.names(), ElementsAre("stage", "load", "boundary", "method", "cells", "time_s", "modulus_Pa"));
  EXPECT_THAT(table.text("stage"), ElementsAre("A", "A", "B", "B"));
  EXPECT_THAT(table.text("load"), ElementsAre("shear", "shear", "bulk", "shear-xx-yy"));
  EXPECT_THAT(table.text("boundary"), ElementsAre("displacement", "displacement", "traction", "periodic"));
  EXPECT_THAT(table.text("method"), ElementsAre("quasistatic", "quasistatic", "dynamic", "quasistatic"));
  EXPECT_THAT(table.text("cells"), ElementsAre("12", "12", "extrapolated", "300"));
  EXPECT_THAT(table.numbers("time_s"), ElementsAre(1e-3, 0.1, 1e-300, 2.0));
  EXPECT_THAT(table.numbers("modulus_Pa"), ElementsAre(1.0 / 3.0, 2e9 / 7.0, 5.0, 4.0));
}

TEST_F(WriteCurves, LeavesTheCompliancesOfCreepTestsAlone) {
  auto creep = test_with({Load::shear, Boundary::traction, Method::quasistatic, TestGrid(12)}, {{1.0, 4.0}});
  creep.compliance = {{1.0, 0.25}, {2.0, 1.0 / 3.0}};
  const auto relaxation = test_with(on_12_cells, {{1.0, 5.0}});
  write_curves(directory.path(), {{stage_with("A", {relaxation})}, {}});
  EXPECT_FALSE(has("compliance.csv"));
  write_curves(directory.path(), {{stage_with("A", {relaxation, creep})}, {}});
  const auto table = read("compliance.csv");
  EXPECT_THAT(table.text("boundary"), Each("traction"));
  EXPECT_THAT(table.numbers("time_s"), ElementsAre(1.0, 2.0));
  EXPECT_THAT(table.numbers("compliance_1_per_Pa"), ElementsAre(0.25, 1.0 / 3.0));
}

TEST_F(WriteCurves, LeavesTheHalfBandsOfExtrapolatedTestsAlone) {
  auto limit = test_with({.grid = TestGrid::extrapolated()}, {{1.0, 3.0}, {2.0, 2.0}});
  limit.half_bands = {0.5, 0.125};
  write_curves(directory.path(), {{stage_with("A", {test_with(on_12_cells, {{1.0, 5.0}})})}, {}});
  EXPECT_FALSE(has("extrapolation.csv"));
  write_curves(directory.path(), {{stage_with("A", {test_with(on_12_cells, {{1.0, 5.0}}), limit})}, {}});
  const auto table = read("extrapolation.csv", {"stage", "load", "boundary", "method"});
  EXPECT_FALSE(table.has("cells")) << "all are of the limit";
  EXPECT_THAT(table.numbers("time_s"), ElementsAre(1.0, 2.0));
  EXPECT_THAT(table.numbers("modulus_Pa"), ElementsAre(3.0, 2.0));
  EXPECT_THAT(table.numbers("half_band_Pa"), ElementsAre(0.5, 0.125));
}

/// A test whose series has only an equilibrium modulus.
TestResult elastic(Boundary boundary, Method method, TestGrid grid, double modulus) {
  auto test = test_with({Load::shear, boundary, method, grid}, {{1.0, modulus}});
  test.series = PronySeries(modulus);
  return test;
}

TEST_F(WriteCurves, LeavesOneSeriesForEachLoadAndBoundary) {
  auto limit = elastic(Boundary::displacement, Method::quasistatic, TestGrid::extrapolated(), 0.0);
  limit.series = PronySeries(7.0, {{0.5, 2.0}, {30.0, 3.0}});
  write_curves(directory.path(),
               {{stage_with("A", {elastic(Boundary::displacement, Method::dynamic, TestGrid::extrapolated(), 1.0),
                                  elastic(Boundary::displacement, Method::quasistatic, TestGrid(12), 2.0), limit,
                                  elastic(Boundary::displacement, Method::quasistatic, TestGrid(24), 4.0),
                                  elastic(Boundary::traction, Method::dynamic, TestGrid(12), 5.0),
                                  elastic(Boundary::traction, Method::dynamic, TestGrid(24), 6.0)})},
                {}});
  const auto table = read("prony.csv", {"stage", "load", "boundary"});
  EXPECT_THAT(table.text("boundary"), ElementsAre("displacement", "displacement", "displacement", "traction"));
  EXPECT_THAT(table.numbers("relaxation_time_s"), ElementsAre(INFINITY, 30.0, 0.5, INFINITY))
      << "the equilibrium modulus, then the terms from slow to fast";
  EXPECT_THAT(table.numbers("modulus_Pa"), ElementsAre(7.0, 3.0, 2.0, 6.0))
      << "the limit before grids, the finest grid before others";
}

// Between samples that are far apart the modulus is linear in ln t: halfway from 10 ms to 1 s it is the mean.
TEST_F(WriteCurves, LeavesTheDistanceOfTheBounds) {
  auto upper = test_with({.grid = TestGrid::extrapolated()}, {{0.01, 4.0}, {1.0, 2.0}});
  upper.half_bands = {0.25, 0.5};
  const auto lower = test_with({.boundary = Boundary::traction, .grid = TestGrid(24)}, {{0.01, 2.0}, {1.0, 1.0}});
  const auto bulk =
      test_with({Load::bulk, Boundary::traction, Method::dynamic, TestGrid(24)}, {{1.0, 8.0}, {2.0, 6.0}});
  write_curves(directory.path(), {{stage_with("A", {upper, lower, bulk})}, {}});
  const auto table = read(
      "quality.csv", {"stage", "load", "method", "upper_Pa", "lower_Pa", "relative_distance", "grid_half_band_Pa"});
  EXPECT_THAT(table.text("load"), ElementsAre("shear", "shear", "shear", "bulk", "bulk"));
  EXPECT_THAT(table.text("method"), ElementsAre("quasistatic", "quasistatic", "quasistatic", "dynamic", "dynamic"));
  EXPECT_THAT(table.numbers("time_s"), ElementsAre(0.01, 0.1, 1.0, 1.0, 2.0));
  const auto number = [&](const char* column, std::size_t row) { return std::stod(table.text(column)[row]); };
  EXPECT_THAT(number("upper_Pa", 1), DoubleNear(3.0, 1e-12));
  EXPECT_THAT(number("lower_Pa", 1), DoubleNear(1.5, 1e-12));
  EXPECT_THAT(number("relative_distance", 1), DoubleNear(1.0, 1e-12));
  EXPECT_EQ(number("grid_half_band_Pa", 0), 0.25);
  EXPECT_EQ(number("grid_half_band_Pa", 2), 0.5);
  EXPECT_EQ(table.text("upper_Pa")[3], "") << "not tested";
  EXPECT_EQ(table.text("lower_Pa")[3], "8");
  EXPECT_EQ(table.text("relative_distance")[3], "");
  EXPECT_EQ(table.text("grid_half_band_Pa")[3], "") << "one grid";
}

/// One Maxwell element beside a spring: M' = M_inf + M x^2 / (1 + x^2), M'' = M x / (1 + x^2), x = omega tau.
TEST_F(WriteCurves, LeavesTheDynamicModuliOfTheBestTests) {
  auto coarse = test_with(on_12_cells, {{1.0, 5.0}});
  coarse.series = PronySeries(1.0);
  auto fine = test_with({.grid = TestGrid(24)}, {{0.5, 5.0}, {2.0, 4.0}});
  fine.series = PronySeries(3.0, {{1.0, 2.0}});
  write_curves(directory.path(), {{stage_with("A", {coarse, fine})}, {}});
  const auto table = read("dynamic.csv", {"stage", "load", "boundary", "method", "cells", "error"});
  EXPECT_THAT(table.text("cells"), Each("24"));
  EXPECT_THAT(table.numbers("angular_frequency_rad_per_s"), ElementsAre(0.5, 2.0));
  EXPECT_THAT(table.numbers("storage_modulus_Pa"), ElementsAre(DoubleNear(3.4, 1e-12), DoubleNear(4.6, 1e-12)));
  EXPECT_THAT(table.numbers("loss_modulus_Pa"), ElementsAre(DoubleNear(0.8, 1e-12), DoubleNear(0.8, 1e-12)));
  EXPECT_THAT(table.numbers("frequency_Hz")[1], DoubleNear(1.0 / std::numbers::pi, 1e-12));
  EXPECT_THAT(table.numbers("absolute_modulus_Pa")[0], DoubleNear(std::sqrt(3.4 * 3.4 + 0.8 * 0.8), 1e-12));
  EXPECT_THAT(table.numbers("phase_angle_deg")[0], DoubleNear(std::atan(0.8 / 3.4) * 180.0 / std::numbers::pi, 1e-9));
  EXPECT_THAT(table.text("error"), Each("")) << "not known";
  EXPECT_THAT(table.numbers("loss_tangent"), ElementsAre(DoubleNear(0.8 / 3.4, 1e-12), DoubleNear(0.8 / 4.6, 1e-12)));
  EXPECT_FALSE(has("engineering.csv")) << "no bulk test";
}

/// An elastic composite with G = 3 and K = 5: E = 9 K G / (3 K + G) = 7.5, nu = (3 K - 2 G) / (6 K + 2 G) = 1/4.
TEST_F(WriteCurves, LeavesTheEngineeringModuliWhereTheLoadsAllowIt) {
  const auto test = [](Load load, double modulus) {
    auto one = test_with({.load = load, .grid = TestGrid(12)}, {{1.0, modulus}, {10.0, modulus}});
    one.series = PronySeries(modulus);
    one.errors = {{.grid = 0.02, .sample = 0.0, .solver = 0.0, .matrix = 0.0}, {}};
    return one;
  };
  for (const int dimensions : {2, 3}) {
    auto stage = stage_with("A", {test(Load::shear, 3.0), test(Load::bulk, dimensions == 2 ? 6.0 : 5.0)});
    stage.dimensions = dimensions;
    write_curves(directory.path(), {{stage}, {}});
    const auto table = read("engineering.csv", {"stage", "boundary", "method", "cells", "bulk_modulus_error",
                                                "youngs_modulus_error", "poisson_ratio_error"});
    EXPECT_THAT(table.numbers("time_s"), ElementsAre(1.0, 10.0));
    EXPECT_THAT(table.numbers("shear_modulus_Pa"), Each(3.0));
    EXPECT_THAT(table.numbers("bulk_modulus_Pa"), Each(DoubleNear(5.0, 1e-12)));
    EXPECT_THAT(table.numbers("youngs_modulus_Pa"), Each(DoubleNear(7.5, 1e-9)));
    EXPECT_THAT(table.numbers("poisson_ratio"), Each(DoubleNear(0.25, 1e-9)));
    EXPECT_THAT(table.numbers("tensile_compliance_1_per_Pa"), Each(DoubleNear(1.0 / 7.5, 1e-9)));
    // In space both errors are 2 % of both moduli, and so that of E; in the plane K is the difference of 6 and 1.
    EXPECT_NEAR(number_if_known(table, "bulk_modulus_error", 0).value(), dimensions == 2 ? 0.028 : 0.02, 1e-12);
    EXPECT_NEAR(number_if_known(table, "youngs_modulus_error", 0).value(), 0.02, 1e-12);
    EXPECT_GT(number_if_known(table, "poisson_ratio_error", 0).value(), 0.0);
    EXPECT_EQ(table.text("youngs_modulus_error")[1], "") << "not known";
    const auto dynamic =
        read("engineering_dynamic.csv", {"stage", "boundary", "method", "cells", "youngs_modulus_error"});
    EXPECT_THAT(dynamic.numbers("angular_frequency_rad_per_s"), ElementsAre(0.1, 1.0));
    EXPECT_THAT(dynamic.numbers("youngs_storage_modulus_Pa"), Each(DoubleNear(7.5, 1e-12)));
    EXPECT_THAT(dynamic.numbers("youngs_loss_modulus_Pa"), Each(DoubleNear(0.0, 1e-12)));
    EXPECT_THAT(dynamic.numbers("poisson_ratio_real"), Each(DoubleNear(0.25, 1e-12)));
  }
}

TEST_F(WriteCurves, FailsWhereThereIsNoDirectory) {
  const StudyResult result{{stage_with("A", {test_with(on_12_cells, {{1.0, 5.0}})})}, {}};
  EXPECT_THROW(write_curves(directory.path() / "nowhere", result), FileError);
}

}  // namespace
}  // namespace breccia
