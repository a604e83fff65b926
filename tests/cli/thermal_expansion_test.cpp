// The thermal expansion of composites, through the command line: beads of glass in a rubber that relaxes in shear
// alone.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/text_file.hpp"
#include "lattice_stage.hpp"
#include "rasters/npy.hpp"
#include "study_directory.hpp"
#include "tables/csv.hpp"

namespace breccia::test::thermal_expansion {
namespace {

using ::testing::AllOf;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr std::string_view materials_and_tests = R"(title = "Glass in rubber"
dimensions = 3

[materials.rubber]
density = "1.1 g/cm^3"
bulk    = "2 GPa"
shear   = { terms = [{ time = "1 ms", modulus = "900 MPa" }], equilibrium = "10 MPa" }
thermal_expansion = "200e-6 /K"

[materials.glass]
density = "2.5 g/cm^3"
bulk    = "40 GPa"
shear   = "30 GPa"
thermal_expansion = "8e-6 /K"

[tests]
times  = ["10 us", "100 ms"]
loads  = ["shear"]
points_per_decade = 3
)";

std::string one_stage() {
  return std::string(materials_and_tests) + lattice_stage("A", "rubber", "glass");
}

/// Larger spheres of a filler in the composite of the first stage.
std::string two_stages(const std::string& filler = "glass") {
  return one_stage() + lattice_stage("B", "A", filler, 10.0);
}

CsvTable read_expansion(const StudyDirectory& study) {
  return read_csv(study.result("thermal_expansion.csv"),
                  {"stage", "load", "boundary", "method", "cells", "error_1_per_K"});
}

/// alpha of two elastic phases by Levin's equation from their bulk moduli and that of the composite, all in Pa.
double by_levin(double matrix, double filler, double composite) {
  return 200e-6 + (8e-6 - 200e-6) * (1.0 / composite - 1.0 / matrix) / (1.0 / filler - 1.0 / matrix);
}

TEST(ThermalExpansionOfARun, FollowsFromTheBulkModulus) {
  const StudyDirectory study(one_stage());
  const auto run = study.breccia("run");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.output, HasSubstr("A, periodic, quasistatic: linear thermal expansion "));
  EXPECT_THAT(run.output, HasSubstr("e-6 /K at 10 us, "));
  const auto table = read_expansion(study);
  const auto bulk = read_curve(study.result("curves.csv"), "A", "bulk");
  ASSERT_EQ(table.rows(), bulk.size()) << "the test in bulk was added";
  // The bulk modulus of the composite falls with the shear modulus of the rubber by a few per cent; where it rests, the
  // phases are as elastic ones.
  const auto& expansion = table.numbers("thermal_expansion_1_per_K");
  EXPECT_NEAR(expansion.front() / by_levin(2e9, 40e9, bulk.front().modulus), 1.0, 1e-3);
  EXPECT_NEAR(expansion.back() / by_levin(2e9, 40e9, bulk.back().modulus), 1.0, 1e-6);
  EXPECT_GT(expansion.back(), expansion.front()) << "a relaxed rubber is held back less";
  const auto document = nlohmann::json::parse(read_text(study.result("study.json")));
  EXPECT_EQ(document.at("materials").at(1).at("thermal_expansion_1_per_K"), 8e-6);
  EXPECT_THAT(read_text(study.result("report.html")), HasSubstr("thermal_expansion.csv"));
}

TEST(ThermalExpansionOfARun, OfEqualExpansionsIsTheSameInEveryStage) {
  const StudyDirectory study(two_stages());
  const auto run = study.breccia("run", {"--set", R"(materials.glass.thermal_expansion="200e-6 /K")"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const auto table = read_expansion(study);
  EXPECT_THAT(table.numbers("thermal_expansion_1_per_K"), Each(::testing::DoubleNear(200e-6, 1e-12)));
  EXPECT_THAT(table.text("stage"), AllOf(::testing::Contains("A"), ::testing::Contains("B")));
}

TEST(ThermalExpansionOfARun, OfASecondStageIsBelowThatOfTheFirst) {
  const StudyDirectory study(two_stages());
  ASSERT_EQ(study.breccia("run").exit_code, 0);
  const auto table = read_expansion(study);
  const auto& expansion = table.numbers("thermal_expansion_1_per_K");
  const std::size_t half = table.rows() / 2;
  for (std::size_t i = 0; i < half; ++i) {
    ASSERT_EQ(table.text("stage")[i], "A");
    EXPECT_LT(expansion[half + i], expansion[i]);
    EXPECT_GT(expansion[half + i], 8e-6);
  }
}

// The tasks of a sweep over the second stage share the first one.
TEST(ThermalExpansionOfARun, OfASharedStageIsThatOfARunOfItsOwn) {
  const StudyDirectory study(two_stages());
  ASSERT_EQ(study.breccia("run", {"--sweep", "stages.1.cells=[6, 8]"}).exit_code, 0);
  const auto shared = read_text(study.result("cells-8/thermal_expansion.csv"));
  ASSERT_EQ(run_breccia(study.path(), {"run", "deck.toml", "--out", "alone"}).exit_code, 0);
  EXPECT_EQ(read_text(study.path() / "alone/thermal_expansion.csv"), shared);
}

TEST(ThermalExpansionOfARun, AVoidTakesNothingFromItsMatrix) {
  const StudyDirectory study(one_stage());
  const auto run = study.breccia("run", {"--set", R"(stages.0.filler.material="void")"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.output, HasSubstr("thermal expansion 200e-6 +- 0e-6 /K at 10 us"));
  EXPECT_THAT(read_expansion(study).numbers("thermal_expansion_1_per_K"), Each(::testing::DoubleNear(200e-6, 1e-10)));
}

TEST(ThermalExpansionOfARun, SaysWhatIsInItsWay) {
  const StudyDirectory study(one_stage());
  const auto of = [&](const std::vector<std::string>& settings) {
    const auto check = study.breccia("check", settings);
    EXPECT_EQ(check.exit_code, 0) << check.errors;
    return check.output + check.errors;
  };
  EXPECT_THAT(of({}), AllOf(Not(HasSubstr("thermal")), HasSubstr("    expands  200e-6 /K\n"),
                            HasSubstr("    loads    shear; A also bulk\n")));
  EXPECT_THAT(of({"--set", "materials.glass.thermal_expansion="}),
              HasSubstr("A: no thermal expansion: glass has no thermal_expansion"));
  EXPECT_THAT(of({"--set", R"(stages.0.filler.coating={ material = "rubber", thickness = "50 um" })"}),
              HasSubstr("A: no thermal expansion: it has more than two phases"));
  EXPECT_THAT(
      of({"--set", R"(materials.glass.bulk="2.1 GPa")"}),
      HasSubstr("A: no thermal expansion: the bulk moduli of glass and rubber come within a tenth of each other"));
  EXPECT_THAT(of({"--set",
                  R"(materials.glass.bulk={ terms = [{ time = "1 ms", modulus = "9 GPa" }], equilibrium = "9 GPa" })"}),
              HasSubstr("A: no thermal expansion: the bulk modulus of glass relaxes"));
}

// The bulk modulus of the first stage comes near that of the filler of the second, 2.7 GPa.
TEST(ThermalExpansionOfARun, WarnsOfAMatrixThatComesNearItsFiller) {
  const StudyDirectory study(two_stages("resin") + R"(
[materials.resin]
density = "1.2 g/cm^3"
bulk    = "2.7 GPa"
shear   = "1 GPa"
thermal_expansion = "60e-6 /K"
)");
  const auto run = study.breccia("run");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.output + run.errors,
              HasSubstr("B, periodic: no thermal expansion: the bulk moduli of resin and A come "
                        "within a tenth of each other"));
  EXPECT_THAT(read_expansion(study).text("stage"), Each("A"));
}

TEST(ThermalExpansionOfARun, OfALaminateIsNotGiven) {
  const StudyDirectory study(std::string(materials_and_tests) + R"(
[[stages]]
name    = "A"
matrix  = "rubber"
packing = { method = "image", file = "layers.npy", pixel = "10 um", periodic = true, labels = [
  { value = 0, material = "rubber" }, { value = 1, material = "glass" }] }
)");
  std::vector<std::uint16_t> labels;
  for (std::size_t i = 0; i < 512; ++i) labels.push_back(i < 128 ? 1 : 0);
  const std::vector<std::size_t> extents = {8, 8, 8};
  write_npy(study.path() / "layers.npy", extents, labels);
  const std::vector<std::string> shears = {"--set", R"(tests.loads="isotropic")"};
  const auto check = study.breccia("check", shears);
  EXPECT_THAT(check.output + check.errors,
              HasSubstr("A: its thermal expansion is that of an isotropic composite, which an image may not show"));
  const auto run = study.breccia("run", shears);
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.output + run.errors, HasSubstr("A: no thermal expansion: its shears are more than a fifth apart"));
  EXPECT_FALSE(std::filesystem::exists(study.result("thermal_expansion.csv")));
}

TEST(ThermalExpansionOfARun, RefusesWhatIsNoExpansion) {
  const StudyDirectory study(one_stage());
  const auto mistake = [&](const std::string& value) {
    const auto check = study.breccia("check", {"--set", "materials.glass.thermal_expansion=" + value});
    EXPECT_EQ(check.exit_code, 2);
    return check.errors;
  };
  EXPECT_THAT(mistake(R"("8 /K")"), HasSubstr("materials.glass.thermal_expansion: expected"));
  EXPECT_THAT(mistake(R"("8 um")"), HasSubstr("expected a thermal expansion"));
  EXPECT_THAT(mistake("8e-6"), HasSubstr("materials.glass.thermal_expansion"));
}

}  // namespace
}  // namespace breccia::test::thermal_expansion
