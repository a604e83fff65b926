// Studies of spheres with gaps narrower than a cell through the command line.

#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/text_file.hpp"
#include "study_directory.hpp"

namespace breccia {
namespace {

using test::read_curve;
using test::run_breccia;
using test::StudyDirectory;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// Rigid spheres in a nearly incompressible matrix that relaxes from 2 to 1 MPa.
constexpr std::string_view rigid_spheres = R"(
dimensions = 3
[materials.matrix]
density = "1.1 g/cm^3"
bulk    = "100 GPa"
shear   = { terms = [ { time = "1 ms", modulus = "1 MPa" } ], equilibrium = "1 MPa" }
[materials.sphere]
density = "2.5 g/cm^3"
bulk    = "100 TPa"
shear   = "10 TPa"
)";

/// Gaps of 1 % of the diameter, an eighth of a cell.
std::string near_contact(std::string_view more = "mixing = \"flow\"\n") {
  return fmt::format(R"({}
[[stages]]
name    = "A"
matrix  = "matrix"
box     = "1 mm"
cells   = 12
filler  = {{ material = "sphere", sizes = {{ diameter = "0.990099 mm" }} }}
packing = {{ method = "regular", lattice = "sc" }}
[tests]
times  = ["10 us", "100 ms"]
loads  = ["shear", "shear-xx-yy"]
points_per_decade = 2
{})",
                     rigid_spheres, more);
}

const std::vector<std::string> without_fields = {"--set", R"(tests.fields="none")"};

// Conforming elements have 4.01 and 62.5 MPa at long times (tests/reference/sphere_packings), and twice that at first.
// The middle of each gap is on a plane of nodes, the worst place.
TEST(SpaceWithGaps, ALatticeOfSpheresThatAlmostTouchHasItsModuli) {
  StudyDirectory study(near_contact());
  const auto check = study.breccia("check");
  ASSERT_EQ(check.exit_code, 0) << check.errors;
  EXPECT_THAT(check.output, AllOf(HasSubstr("with flow through gaps below 1.5 cells"),
                                  HasSubstr("12 cells across the smallest sphere")));
  const auto run = study.breccia("run", without_fields);
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.output, AllOf(HasSubstr("0.12 cells, the matrix flows through it"),
                                Not(HasSubstr("smallest gap between spheres"))));
  for (const auto& [load, expected] : {std::pair<std::string, double>{"shear", 4.01e6}, {"shear-xx-yy", 62.5e6}}) {
    const auto curve = read_curve(study.result("curves.csv"), "A", load);
    ASSERT_FALSE(curve.empty());
    EXPECT_NEAR(curve.back().modulus / expected, 1.0, 0.09) << load;
    EXPECT_NEAR(curve.front().modulus / (2.0 * expected), 1.0, 0.1) << load;
  }
  const auto summary = nlohmann::json::parse(read_text(study.result("study.json")));
  EXPECT_THAT(summary.dump(), HasSubstr(R"("mixing":"flow")"));
}

TEST(SpaceWithGaps, CellsInSeriesAreWarnedAbout) {
  StudyDirectory study(near_contact(""));
  const auto check = study.breccia("check");
  ASSERT_EQ(check.exit_code, 0) << check.errors;
  EXPECT_THAT(check.output, HasSubstr("mixed in series where"));
  EXPECT_THAT(check.output + check.errors, AllOf(HasSubstr("the smallest gap between spheres, 9.901 um, is 0.12 cells"),
                                                 HasSubstr("tests.mixing = \"flow\" represents it")));
}

TEST(SpaceWithGaps, ARandomPackingHasARuleForItsError) {
  StudyDirectory study(near_contact());
  const std::vector<std::string> packed = {
      "--set",
      R"(stages.0.filler={ material = "sphere", fraction = 0.4, sizes = { diameter = "0.4 mm" }, gap = "4 um" })",
      "--set", R"(stages.0.packing={ method = "lubachevsky-stillinger", walls = false })"};
  const auto cells = [&](const std::string& number) {
    auto arguments = packed;
    arguments.insert(arguments.end(), {"--set", "stages.0.cells=" + number});
    const auto check = study.breccia("check", arguments);
    EXPECT_EQ(check.exit_code, 0) << check.errors;
    return check.output + check.errors;
  };
  EXPECT_THAT(cells("20"),
              HasSubstr("8 cells across the smallest sphere, the error of the grid is up to about 13 % by a rule of "
                        "packings of 52 and 55 %; no number of cells is known for 5 %"));
  EXPECT_THAT(cells("16"), HasSubstr("is 6.4 cells wide; below 7 cells no rule gives the error of the grid"));
}

// Several processes solve such boxes by sparse factors.
TEST(SpaceWithGaps, CheckSaysWhatSeveralProcessesTake) {
  StudyDirectory study(near_contact());
  const auto check = [&](const std::string& diameter) {
    return study.breccia("check", {"--processes", "4", "--set", "stages.0.cells=48", "--set",
                                   fmt::format(R"(stages.0.filler.sizes.diameter="{}")", diameter)});
  };
  EXPECT_THAT(check("0.99 mm").output, HasSubstr("on 4 processes: spheres with flow through gaps take sparse factors"));
  EXPECT_THAT(check("0.8 mm").output, HasSubstr("on 4 processes with a core each at best 1/4 of the time"));
}

// A lattice with wide gaps has none with flow, and takes the memory of cells in series.
TEST(SpaceWithGaps, WideGapsOfALatticeTakeNoMemory) {
  StudyDirectory study(near_contact());
  const auto memory_with = [&](const std::string& mixing) {
    const auto check =
        study.breccia("check", {"--set", "stages.0.cells=128", "--set", R"(stages.0.filler.sizes.diameter="0.8 mm")",
                                "--set", fmt::format(R"(tests.mixing="{}")", mixing)});
    EXPECT_EQ(check.exit_code, 0) << check.errors;
    return check.output.substr(check.output.find("together about"));
  };
  EXPECT_EQ(memory_with("flow"), memory_with("series"));
}

TEST(SpaceWithGaps, RespondAnswersForTheSameMatrix) {
  StudyDirectory study(near_contact());
  ASSERT_EQ(study.breccia("run", without_fields).exit_code, 0);
  study.write("same.toml", R"(density = "1.1 g/cm^3"
bulk  = "100 GPa"
shear = { terms = [ { time = "1 ms", modulus = "1 MPa" } ], equilibrium = "1 MPa" }
)");
  const auto respond = run_breccia(study.path(), {"respond", "out", "--material", "same.toml"});
  ASSERT_EQ(respond.exit_code, 0) << respond.errors;
  const auto before = read_curve(study.result("curves.csv"), "A", "shear-xx-yy");
  const auto after = read_curve(study.result("respond-same/curves.csv"), "A", "shear-xx-yy");
  ASSERT_EQ(after.size(), before.size());
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(after[i].modulus / before[i].modulus, 1.0, 1e-6);
}

// A coating that is softer than the sphere and stiffer than the matrix takes a part of the gap.
TEST(SpaceWithGaps, CoatedSpheresHaveFlowBetweenTheirCoatings) {
  const std::string coating = "[materials.coat]\ndensity = \"1 g/cm^3\"\nbulk = \"100 GPa\"\nshear = \"1 GPa\"\n";
  StudyDirectory study(fmt::format("{}{}", near_contact(), coating));
  const auto run =
      study.breccia("run", {"--set", R"(stages.0.filler.coating={ material = "coat", thickness = "2 um" })", "--set",
                            R"(stages.0.filler.sizes.diameter="0.986 mm")"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  // The coated spheres are as wide as the others.
  const auto curve = read_curve(study.result("curves.csv"), "A", "shear-xx-yy");
  EXPECT_NEAR(curve.back().modulus / 62.5e6, 1.0, 0.1);
  EXPECT_THAT(study.results(), Contains("A/fields.vtkhdf"));
}

TEST(SpaceWithGaps, WhatFlowDoesNotServeIsRefused) {
  const auto mistakes = [](const std::vector<std::string>& changes) {
    StudyDirectory study(near_contact());
    std::vector<std::string> arguments;
    for (const auto& change : changes) arguments.insert(arguments.end(), {"--set", change});
    const auto check = study.breccia("check", arguments);
    EXPECT_EQ(check.exit_code, 2) << check.output;
    return check.errors;
  };
  EXPECT_THAT(mistakes({R"(tests.boundaries=["periodic", "traction"])"}),
              HasSubstr(R"(stage A: in three dimensions: expected tests.boundaries = ["periodic"])"));
  EXPECT_THAT(mistakes({R"(stages.0.filler={ material = "sphere", fraction = 0.2, shape = { aspect = 2 }, sizes = { )"
                        R"(diameter = "0.3 mm" }, gap = "1 um" })",
                        R"(stages.0.packing={ method = "random-sequential", walls = false })"}),
              HasSubstr("stage A: in three dimensions: expected spheres"));
  EXPECT_THAT(
      mistakes({R"(stages.0.filler={ material = "sphere", fraction = 0.2, sizes = { diameter = "0.3 mm" }, gap = )"
                R"("1 um" })",
                R"(stages.0.packing={ method = "lubachevsky-stillinger", walls = true })"}),
      HasSubstr("stage A: in three dimensions: expected a periodic box"));
  EXPECT_THAT(mistakes({R"(tests.method="dynamic")"}), HasSubstr(R"(expected method "quasistatic")"));
}

}  // namespace
}  // namespace breccia
