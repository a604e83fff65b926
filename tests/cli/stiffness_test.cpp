// The whole stiffness of composites, through the command line.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/text_file.hpp"
#include "rasters/npy.hpp"
#include "study_directory.hpp"
#include "tables/csv.hpp"

namespace breccia::test {
namespace {

using ::testing::Each;
using ::testing::HasSubstr;

/// Layers of a glass in an elastic resin, a quarter of them glass, whose normal is the last axis of the labels.
constexpr std::string_view laminate = R"(
[materials.resin]
density = "1.2 g/cm^3"
bulk    = "4 GPa"
shear   = "1.5 GPa"
[materials.glass]
density = "2.5 g/cm^3"
bulk    = "40 GPa"
shear   = "30 GPa"

[[stages]]
name    = "A"
matrix  = "resin"
packing = { method = "image", file = "layers.npy", pixel = "10 um", periodic = true, labels = [
  { value = 0, material = "resin" }, { value = 1, material = "glass" }] }

[tests]
times = ["1 us", "1 ms"]
loads = "stiffness"
points_per_decade = 1
)";

std::string laminate_in_space() {
  return "dimensions = 3\n" + std::string(laminate);
}

/// The labels of layers along x, which is the last axis of an array.
void write_layers(const StudyDirectory& study, const std::vector<std::size_t>& extents) {
  std::size_t pixels = 1;
  for (const auto extent : extents) pixels *= extent;
  std::vector<std::uint16_t> labels;
  for (std::size_t i = 0; i < pixels; ++i) labels.push_back(i % extents.back() < extents.back() / 4 ? 1 : 0);
  write_npy(study.path() / "layers.npy", extents, labels);
}

CsvTable read_stiffness_table(const StudyDirectory& study, const std::string& file = "stiffness.csv") {
  return read_csv(study.result(file), {"stage", "load", "boundary", "method", "cells", "anisotropy", "error"});
}

/// The mean over the layers of the laminate.
double mean(double of_resin, double of_glass) {
  return 0.75 * of_resin + 0.25 * of_glass;
}

/// The exact constants of the laminate with the normal x (Backus, J. Geophys. Res. 67, 4427, 1962).
struct LayeredBody {
  double normal, across, along, along_along, shear_across, shear_along;
};

LayeredBody exact_laminate() {
  const std::array bulk = {4e9, 40e9}, shear = {1.5e9, 30e9};
  std::array<double, 2> wave{}, lame{};
  for (std::size_t i = 0; i < 2; ++i) {
    wave[i] = bulk[i] + 4.0 / 3.0 * shear[i];
    lame[i] = bulk[i] - 2.0 / 3.0 * shear[i];
  }
  const double normal = 1.0 / mean(1.0 / wave[0], 1.0 / wave[1]);
  const double share = mean(lame[0] / wave[0], lame[1] / wave[1]);
  const double along =
      mean(wave[0] - lame[0] * lame[0] / wave[0], wave[1] - lame[1] * lame[1] / wave[1]) + share * share * normal;
  const double shear_along = mean(shear[0], shear[1]);
  return {.normal = normal,
          .across = share * normal,
          .along = along,
          .along_along = along - 2.0 * shear_along,
          .shear_across = 1.0 / mean(1.0 / shear[0], 1.0 / shear[1]),
          .shear_along = shear_along};
}

/// A constant by Voigt's numbers, and its exact value.
struct Constant {
  std::string numbers;
  double exact;
};

void expect_constants(const CsvTable& table, const std::vector<Constant>& expected) {
  constexpr double tolerance = 1e-8;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (const auto& [numbers, exact] : expected) {
      EXPECT_NEAR(table.numbers("C" + numbers + "_Pa")[row], exact, tolerance * 40e9) << "C" << numbers;
    }
  }
}

TEST(StiffnessOfARun, OfALaminateInSpaceIsExact) {
  const StudyDirectory study(laminate_in_space());
  write_layers(study, {8, 8, 8});
  const auto run = study.breccia("run");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.output, HasSubstr("A, periodic: universal index of anisotropy"));
  EXPECT_THAT(study.breccia("check").output, HasSubstr("isotropic, bulk, pairs of loads for the whole stiffness"));
  const auto exact = exact_laminate();
  const auto table = read_stiffness_table(study);
  EXPECT_EQ(table.rows(), 4U);
  std::vector<Constant> expected = {{"11", exact.normal},      {"12", exact.across},       {"13", exact.across},
                                    {"22", exact.along},       {"33", exact.along},        {"23", exact.along_along},
                                    {"44", exact.shear_along}, {"55", exact.shear_across}, {"66", exact.shear_across}};
  for (const auto* zero : {"14", "15", "16", "24", "25", "26", "34", "35", "36", "45", "46", "56"}) {
    expected.push_back({zero, 0.0});
  }
  expect_constants(table, expected);
}

TEST(StiffnessOfARun, OfALaminateInThePlaneIsExact) {
  const StudyDirectory study{std::string(laminate)};
  write_layers(study, {16, 16});
  const auto run = study.breccia("run");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const auto exact = exact_laminate();
  const auto table = read_stiffness_table(study);
  EXPECT_EQ(table.rows(), 4U);
  expect_constants(table, {{"11", exact.normal},
                           {"12", exact.across},
                           {"22", exact.along},
                           {"16", 0.0},
                           {"26", 0.0},
                           {"66", exact.shear_across}});
}

// The isotropic part has the moduli of the curves.
TEST(StiffnessOfARun, HasTheIsotropicModuliOfItsCurves) {
  const StudyDirectory study{std::string(laminate)};
  write_layers(study, {16, 16});
  ASSERT_EQ(study.breccia("run").exit_code, 0);
  const auto table = read_stiffness_table(study);
  const auto shear = modulus_at(read_curve(study.result("curves.csv"), "A", "isotropic"), 1e-3);
  const auto plane = modulus_at(read_curve(study.result("curves.csv"), "A", "bulk"), 1e-3);
  EXPECT_NEAR(table.numbers("shear_modulus_Pa").back() / shear, 1.0, 1e-9);
  EXPECT_NEAR(table.numbers("bulk_modulus_Pa").back() / (plane - shear / 3.0), 1.0, 1e-9);
}

/// Discs in a binder that relaxes, on two grids.
constexpr std::string_view discs = R"(
[materials.binder]
density = "1.2 g/cm^3"
bulk    = "3 GPa"
shear   = { equilibrium = "10 MPa", terms = [{ time = "1 ms", modulus = "0.5 GPa" }] }
[materials.glass]
density = "2.5 g/cm^3"
bulk    = "40 GPa"
shear   = "30 GPa"

[[stages]]
name    = "A"
matrix  = "binder"
cells   = [16, 32]
filler  = { material = "glass", fraction = 0.3, sizes = { diameter = "0.1 mm" } }
packing = { method = "lubachevsky-stillinger", seed = 2 }
particles = 20

[tests]
times = ["1 us", "0.1 s"]
loads = "stiffness"
points_per_decade = 2
)";

/// A second stage, for which the first one is the same.
constexpr std::string_view larger_discs = R"(
[[stages]]
name    = "B"
matrix  = "A"
cells   = 16
filler  = { material = "glass", fraction = 0.2, sizes = { diameter = "1 mm" } }
packing = { method = "lubachevsky-stillinger", seed = 3 }
particles = 8
)";

/// The largest error of a time among those of the single loads in errors.csv.
double largest_error_at(const StudyDirectory& study, double time) {
  const auto table =
      read_csv(study.result("errors.csv"), {"stage", "load", "boundary", "method", "cells", "error", "grid_error",
                                            "sample_error", "solver_error", "matrix_error"});
  double largest = 0.0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (table.numbers("time_s")[row] != time || table.text("load")[row] == "isotropic") continue;
    largest = std::max(largest, std::stod(table.text("error")[row]));
  }
  return largest;
}

TEST(StiffnessOfARun, OfSeveralGridsHasTheErrorOfItsModuli) {
  const StudyDirectory study{std::string(discs)};
  const auto run = study.breccia("run");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const auto table = read_stiffness_table(study);
  ASSERT_GT(table.rows(), 0U);
  EXPECT_EQ(table.text("cells").front(), "extrapolated");
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double expected = largest_error_at(study, table.numbers("time_s")[row]);
    EXPECT_GT(expected, 0.0);
    EXPECT_NEAR(std::stod(table.text("error")[row]), expected, 1e-12);
    EXPECT_LT(std::stod(table.text("anisotropy")[row]), 0.5) << "a random packing is nearly isotropic";
  }
}

// Interrupted after its first calculation, and again and again.
TEST(StiffnessOfARun, OfAResumedRunIsThatOfARunInOneGo) {
  const StudyDirectory whole{std::string(discs)}, study{std::string(discs)};
  ASSERT_EQ(whole.breccia("run").exit_code, 0);
  double limit = 50.0;
  int interruptions = 0;
  for (int exit_code = 130; exit_code != 0; limit *= 1.1) {
    const auto run = study.breccia("run", {"--resume", "--time-limit", fmt::format("{} ms", limit)});
    exit_code = run.exit_code;
    ASSERT_TRUE(exit_code == 0 || exit_code == 130) << run.errors;
    interruptions += exit_code == 130 ? 1 : 0;
  }
  EXPECT_GT(interruptions, 0);
  EXPECT_EQ(read_text(study.result("stiffness.csv")), read_text(whole.result("stiffness.csv")));
}

// Steps in time have an error of 1e-3 and no basis.
TEST(StiffnessOfARun, IsThatOfStepsInTime) {
  const std::vector<std::string> one_grid = {"--set", "stages.0.cells=16"};
  const StudyDirectory reduced{std::string(discs)}, stepping{std::string(discs)};
  ASSERT_EQ(reduced.breccia("run", one_grid).exit_code, 0);
  ASSERT_EQ(stepping.breccia("run", {"--set", "stages.0.cells=16", "--set", R"(tests.solver="stepping")"}).exit_code,
            0);
  const auto one = read_stiffness_table(reduced), other = read_stiffness_table(stepping);
  ASSERT_EQ(one.rows(), other.rows());
  for (const auto* column : {"C11_Pa", "C12_Pa", "C16_Pa", "C22_Pa", "C26_Pa", "C66_Pa"}) {
    for (std::size_t row = 0; row < one.rows(); ++row) {
      EXPECT_NEAR(one.numbers(column)[row], other.numbers(column)[row], 2e-3 * one.numbers("C11_Pa")[row]) << column;
    }
  }
}

// A box between walls is tested under displacements and tractions; tractions give no stiffness.
TEST(StiffnessOfARun, BesideTractionsIsThatUnderDisplacements) {
  const StudyDirectory study{std::string(discs)};
  const auto run = study.breccia(
      "run", {"--set", "stages.0.cells=16", "--set", "stages.0.packing.walls=true", "--set",
              R"(tests.boundaries=["traction", "displacement"])", "--set", R"(tests.loads=["shear", "stiffness"])"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(read_stiffness_table(study).text("boundary"), Each("displacement"));
}

TEST(StiffnessOfARun, OfGrainsWithFilmsHasTheIsotropicModuliOfItsCurves) {
  const StudyDirectory study(R"([materials.binder]
density = "1.2 g/cm^3"
bulk    = "3 GPa"
shear   = { equilibrium = "1 MPa", terms = [{ time = "1 ms", modulus = "0.5 GPa" }] }
[materials.crystal]
density   = "1.9 g/cm^3"
stiffness = { symmetry = "cubic", C11 = "20 GPa", C12 = "14 GPa", C44 = "12 GPa" }

[[stages]]
name      = "A"
matrix    = "binder"
particles = 20
filler    = { material = "crystal", fraction = 0.93, sizes = { diameter = "0.1 mm" } }
packing   = { method = "laguerre", seed = 4 }

[tests]
model = "films"
times = ["1 us", "0.1 s"]
loads = "stiffness"
points_per_decade = 2
)");
  const auto run = study.breccia("run");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const auto table = read_stiffness_table(study);
  const auto shear = read_curve(study.result("curves.csv"), "A", "isotropic");
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double modulus = modulus_at(shear, table.numbers("time_s")[row]);
    EXPECT_NEAR(table.numbers("shear_modulus_Pa")[row] / modulus, 1.0, 1e-6);
    EXPECT_GT(std::stod(table.text("anisotropy")[row]), 0.0);
  }
}

TEST(StiffnessOfARun, OfASharedStageIsThatOfARunOfItsOwn) {
  const StudyDirectory study(std::string(discs) + std::string(larger_discs));
  ASSERT_EQ(study.breccia("run", {"--sweep", "stages.1.cells=[12, 16]"}).exit_code, 0);
  const auto run = run_breccia(study.path(), {"run", "deck.toml", "--out", "alone"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_EQ(read_text(study.path() / "alone/stiffness.csv"), read_text(study.result("cells-16/stiffness.csv")));
}

TEST(StiffnessOfARun, RefusesWhatHasNone) {
  const StudyDirectory study{std::string(discs)};
  const auto mistake = [&](const std::vector<std::string>& settings) {
    const auto check = study.breccia("check", settings);
    EXPECT_EQ(check.exit_code, 2);
    return check.errors;
  };
  EXPECT_THAT(mistake({"--set", R"(tests.method="dynamic")"}),
              HasSubstr(R"(loads "stiffness" is for method "quasistatic")"));
  EXPECT_THAT(mistake({"--set", R"(tests.boundaries=["traction"])"}),
              HasSubstr(R"(expected "periodic" or "displacement")"));
  EXPECT_THAT(mistake({"--set", R"(tests.loads="tensor")"}), HasSubstr(R"(expected "isotropic", "stiffness" or)"));
  EXPECT_THAT(mistake({"--set", R"(tests.loads=["stiffness", "stiffness"])"}), HasSubstr("the same twice"));
}

}  // namespace
}  // namespace breccia::test
