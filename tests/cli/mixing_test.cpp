// Tests of decks with the key tests.mixing.

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/text_file.hpp"
#include "model_deck.hpp"
#include "study_directory.hpp"
#include "tables/csv.hpp"

namespace breccia::test {
namespace {

using ::testing::HasSubstr;

const std::vector<std::string> mixed = {"--set", "tests.mixing=series",
                                        "--set", "tests.volumetric=averaged",
                                        "--set", R"(tests.method=["quasistatic", "dynamic"])"};

std::vector<std::string> with(std::vector<std::string> options, const std::vector<std::string>& more) {
  options.insert(options.end(), more.begin(), more.end());
  return options;
}

/// Moduli [Pa] by one method, in order of time.
std::vector<double> moduli(const StudyDirectory& study, const std::string& method) {
  const auto table = read_csv(study.result("curves.csv"), {"stage", "load", "boundary", "method", "cells"});
  std::vector<double> moduli;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (table.text("method")[row] == method) moduli.push_back(table.numbers("modulus_Pa")[row]);
  }
  return moduli;
}

// The dynamic method takes the mixtures as materials, the quasi-static one strains of each phase.
TEST(Mixing, BothMethodsAgreeOnMixedCells) {
  const StudyDirectory study(model_deck);
  const auto run = study.breccia("run", with(mixed, {"--set", R"(tests.times=["1 ms", "30 ms"])"}));
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const auto slow = moduli(study, "quasistatic"), fast = moduli(study, "dynamic");
  ASSERT_EQ(slow.size(), fast.size());
  ASSERT_FALSE(slow.empty());
  for (std::size_t i = 0; i < slow.size(); ++i) EXPECT_NEAR(fast[i] / slow[i], 1.0, 0.01) << i;
  // The expected value is the limit of points, from 48 and 96 cells of another program that agrees to four digits.
  // Points with 24 cells are off by 10 % after 1 ms, and by 33 % after 30 ms.
  EXPECT_NEAR(slow.front() / (2.0 * 0.822523e6 - 0.841164e6), 1.0, 0.015);
  EXPECT_NEAR(slow.back() / (2.0 * 0.0957985e6 - 0.102588e6), 1.0, 0.04);
  const auto record = nlohmann::json::parse(read_text(study.result("study.json")));
  for (const auto& test : record.at("stages").at(0).at("tests")) EXPECT_EQ(test.at("mixing"), "series");
}

// The deck has standard points, so that each point has the phase at its position.
TEST(Mixing, IsInSeriesWhereStrainsAreAveraged) {
  const StudyDirectory study(model_deck);
  EXPECT_THAT(study.breccia("check", {"--set", "tests.volumetric=averaged"}).output, HasSubstr("mixed in series"));
  EXPECT_THAT(study.breccia("check", {}).output, HasSubstr("each point of the phase at its place"));
}

/// Two stages of four discs each, on two grids.
constexpr const char* stages_on_two_grids = R"(
title = "two stages"

[materials.binder]
density = "1.0 g/cm^3"
bulk    = "1.0 GPa"
shear   = { terms = [{ time = "1 ms", modulus = "100 MPa" }, { time = "1 s", modulus = "1 MPa" }], equilibrium = "10 kPa" }

[materials.glass]
density = "2.5 g/cm^3"
bulk    = "40 GPa"
shear   = "30 GPa"

[[stages]]
name    = "fine"
matrix  = "binder"
box     = "1 mm"
cells   = [24, 48]
filler  = { material = "glass", sizes = { diameter = "0.4 mm" } }
packing = { method = "regular", columns = 2, rows = 2 }

[[stages]]
name    = "coarse"
matrix  = "fine"
box     = "10 mm"
cells   = [24, 48]
filler  = { material = "glass", sizes = { diameter = "4 mm" } }
packing = { method = "regular", columns = 2, rows = 2 }

[tests]
loads = ["shear"]
times  = ["10 us", "10 s"]
fields = "none"
)";

/// Shear moduli [Pa] of the second stage under the displacement boundary on one grid.
std::vector<double> of_second_stage(const StudyDirectory& study, const std::string& cells) {
  const auto table = read_csv(study.result("curves.csv"), {"stage", "load", "boundary", "method", "cells"});
  std::vector<double> moduli;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (table.text("stage")[row] != "coarse" || table.text("boundary")[row] != "displacement") continue;
    if (table.text("cells")[row] == cells) moduli.push_back(table.numbers("modulus_Pa")[row]);
  }
  return moduli;
}

TEST(Mixing, StagesBuildOnStagesAndTheFinestGridGivesTheResult) {
  const StudyDirectory study(stages_on_two_grids);
  const auto run = study.breccia("run", {});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const auto coarse = of_second_stage(study, "24"), fine = of_second_stage(study, "48");
  ASSERT_FALSE(fine.empty());
  EXPECT_EQ(of_second_stage(study, "extrapolated"), fine);
  const auto bands = read_csv(study.result("extrapolation.csv"), {"stage", "load", "boundary", "method"});
  std::size_t rows = 0;
  double change = 0.0;  // largest change so far
  for (std::size_t row = 0; row < bands.rows(); ++row) {
    if (bands.text("stage")[row] != "coarse" || bands.text("boundary")[row] != "displacement") continue;
    change = std::max(change, std::abs(coarse.at(rows) / fine.at(rows) - 1.0));
    EXPECT_NEAR(bands.numbers("half_band_Pa")[row] / fine.at(rows), 2.0 * change, 1e-9);
    ++rows;
  }
  EXPECT_EQ(rows, fine.size());
  // The limit of points is taken from many more cells.
  const StudyDirectory points(stages_on_two_grids);
  const auto finer = points.breccia("run", {"--set", "tests.mixing=points", "--set", "stages.*.cells=[120, 240]"});
  ASSERT_EQ(finer.exit_code, 0) << finer.errors;
  const auto limit = of_second_stage(points, "extrapolated");
  ASSERT_EQ(limit.size(), fine.size());
  for (std::size_t i = 0; i < limit.size(); ++i) EXPECT_NEAR(fine[i] / limit[i], 1.0, 0.03) << i;
}

/// Moduli [Pa] of the second stage by load, in order of time.
std::map<std::string, std::vector<double>> of_second_stage_by(const StudyDirectory& study, const std::string& method) {
  const auto table = read_csv(study.result("curves.csv"), {"stage", "load", "boundary", "method", "cells"});
  std::map<std::string, std::vector<double>> moduli;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (table.text("stage")[row] != "coarse" || table.text("method")[row] != method) continue;
    moduli[table.text("load")[row]].push_back(table.numbers("modulus_Pa")[row]);
  }
  return moduli;
}

// The matrix relaxes in bulk as in shear; the mixtures' terms follow from both.
TEST(Mixing, BothMethodsAgreeWithAStageAsMatrix) {
  const StudyDirectory study(stages_on_two_grids);
  const auto run = study.breccia(
      "run", with(mixed, {"--set", "stages.*.cells=16", "--set", R"(tests.times=["10 us", "30 ms"])", "--set",
                          R"(tests.loads=["shear", "bulk"])", "--set", R"(tests.boundaries=["displacement"])"}));
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const auto slow = of_second_stage_by(study, "quasistatic"), fast = of_second_stage_by(study, "dynamic");
  for (const auto* load : {"shear", "bulk"}) {
    ASSERT_EQ(slow.at(load).size(), fast.at(load).size());
    ASSERT_FALSE(slow.at(load).empty());
    for (std::size_t i = 0; i < slow.at(load).size(); ++i) {
      EXPECT_NEAR(fast.at(load)[i] / slow.at(load)[i], 1.0, 0.015) << load << ", " << i;
    }
  }
}

// Gaps between discs and walls of a twelfth of a cell. Where discs deform and the binder is somewhat compressible, some
// per cent are missing; cells in series are too stiff by a factor at late times.
TEST(Mixing, WithFlowNeedsFewCellsInNarrowGaps) {
  const auto moduli_with = [](const std::string& mixing, int cells) {
    const StudyDirectory study(model_deck);
    const auto run =
        study.breccia("run", {"--set", "tests.method=quasistatic", "--set", "tests.volumetric=averaged", "--set",
                              "tests.mixing=" + mixing, "--set", R"(tests.loads=["shear-xx-yy"])", "--set",
                              "stages.A.filler.sizes.diameter=2.96 mm", "--set", "materials.binder.bulk=1 GPa", "--set",
                              "materials.particle.bulk=5 GPa", "--set", "materials.particle.shear=2 GPa", "--set",
                              "stages.A.cells=" + std::to_string(cells)});
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    EXPECT_EQ((run.output + run.errors).find("cannot be squeezed out") == std::string::npos, mixing == "flow");
    return moduli(study, "quasistatic");
  };
  const auto coarse = moduli_with("flow", 24), fine = moduli_with("flow", 66), in_series = moduli_with("series", 24);
  ASSERT_EQ(coarse.size(), fine.size());
  for (std::size_t i = 0; i < coarse.size(); ++i) EXPECT_NEAR(coarse[i] / fine[i], 1.0, 0.1) << i;
  EXPECT_GT(in_series.back() / fine.back(), 1.8);
}

// Ellipses, coated polygons and grains. Wide films between grains are in series.
TEST(Mixing, WithFlowServesOtherShapesAndGrains) {
  constexpr std::string_view shapes = R"(
[materials.rubber]
density = "1 g/cm^3"
bulk    = "3 GPa"
shear   = { equilibrium = "0.5 MPa", terms = [{ time = "1 ms", modulus = "200 MPa" }] }

[materials.crystal]
density = "1.8 g/cm^3"
bulk    = "13 GPa"
shear   = "6 GPa"

[materials.interphase]
density = "1.1 g/cm^3"
bulk    = "3 GPa"
shear   = "0.4 GPa"

[[stages]]
name    = "A"
matrix  = "rubber"
box     = "1 mm"
cells   = 60
packing = { method = "random-sequential", walls = true, seed = 1 }

[[stages.filler]]
material = "crystal"
fraction = 0.3
sizes    = { diameter = "250 um" }
shape    = { aspect = 1.5 }
gap      = "5 um"
coating  = { material = "interphase", thickness = "15 um" }

[tests]
loads = ["shear"]
times  = ["1 us", "100 ms"]
mixing = "flow"
)";
  const StudyDirectory study(shapes);
  const auto run = study.breccia("run", {});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const auto values = moduli(study, "quasistatic");
  EXPECT_GT(values.front(), values.back());

  const std::vector<std::string> grains = {"--set", "stages.A.packing={ method = \"laguerre\", seed = 2 }", "--set",
                                           "stages.A.filler=[{ material = \"crystal\", fraction = 0.9, sizes = { "
                                           "diameter = \"250 um\" } }]"};
  const StudyDirectory narrow(shapes), wide(shapes), in_series(shapes);
  ASSERT_EQ(narrow.breccia("run", with(grains, {"--set", "stages.A.cells=60"})).exit_code, 0);
  const auto wider = with(grains, {"--set", "stages.A.cells=160"});
  ASSERT_EQ(wide.breccia("run", wider).exit_code, 0);
  ASSERT_EQ(in_series.breccia("run", with(wider, {"--set", "tests.mixing=series"})).exit_code, 0);
  EXPECT_EQ(moduli(wide, "quasistatic"), moduli(in_series, "quasistatic"));
  EXPECT_NEAR(moduli(narrow, "quasistatic").back() / moduli(wide, "quasistatic").back(), 1.0, 0.15);
}

// A deck that names no mixing has flow where a gap is narrower than one and a half cells.
TEST(Mixing, IsWithFlowByDefaultWhereGapsAreNarrow) {
  const std::vector<std::string> by_default = {"--set", "tests.method=quasistatic", "--set",
                                               "tests.volumetric=averaged"};
  const auto moduli_with = [&](const std::vector<std::string>& others) {
    const StudyDirectory study(model_deck);
    const auto run = study.breccia("run", with(by_default, others));
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    return std::pair(moduli(study, "quasistatic"), run.output);
  };
  const std::vector<std::string> flow = {"--set", "tests.mixing=flow"}, series = {"--set", "tests.mixing=series"};
  EXPECT_EQ(moduli_with({}).first, moduli_with(series).first) << "gaps of four cells";
  EXPECT_EQ(moduli_with(flow).first, moduli_with(series).first);
  const std::vector<std::string> narrow = {"--set", "stages.A.filler.sizes.diameter=2.96 mm"};
  const auto [values, output] = moduli_with(narrow);
  EXPECT_THAT(output, HasSubstr("cells, the matrix flows through it"));
  EXPECT_EQ(values, moduli_with(with(narrow, flow)).first);
  EXPECT_NE(values, moduli_with(with(narrow, series)).first);
}

TEST(Mixing, WithFlowIsRefusedWhereItDoesNotServe) {
  const StudyDirectory study(model_deck);
  const auto refused = study.breccia("check", {"--set", "tests.mixing=flow", "--set", "tests.volumetric=averaged"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.errors, HasSubstr(R"(mixing "flow": expected method "quasistatic")"));
}

TEST(Mixing, WithFlowSaysWhereFillersAreTooSoftForIt) {
  const StudyDirectory study(model_deck);
  const auto check = study.breccia(
      "check", {"--set", "tests.mixing=flow", "--set", "tests.volumetric=averaged", "--set", "tests.method=quasistatic",
                "--set", "stages.A.filler.sizes.diameter=2.96 mm", "--set", "materials.particle.shear=0.1 MPa"});
  EXPECT_EQ(check.exit_code, 0) << check.errors;
  EXPECT_THAT(check.output + check.errors, HasSubstr("its cells are in series, without flow through gaps"));
}

TEST(Mixing, InSeriesIsRefusedWithStrainsOfPoints) {
  const StudyDirectory study(model_deck);
  const auto refused = study.breccia("check", {"--set", "tests.mixing=series"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.errors, HasSubstr(R"(mixing "series" takes the volumetric strains "averaged")"));
}

}  // namespace
}  // namespace breccia::test
