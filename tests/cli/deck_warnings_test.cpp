#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "good_deck.hpp"
#include "io/text_file.hpp"
#include "messages.hpp"
#include "model_deck.hpp"
#include "study_directory.hpp"

namespace breccia::test {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::json;

/// The model composite by the quasi-static method, with a second stage of one particle of 2 mm built on it.
std::string two_stages() {
  auto deck = replaced(std::string(model_deck), "\"dynamic\"", "\"quasistatic\"");
  deck = replaced(deck, "cells   = 24", "cells   = 12");
  return deck + R"(
[[stages]]
name    = "B"
matrix  = "A"
box     = "6 mm"
cells   = 12
filler  = { material = "particle", sizes = { diameter = "2 mm" } }
packing = { method = "regular", columns = 1, rows = 1 }
)";
}

TEST(DeckWarnings, ReachCheckAndRunAndTheRecordAndTheReport) {
  const StudyDirectory study(replaced(two_stages(), "bulk    = \"1 MPa\"", "bulk    = \"0.2 MPa\""));
  const auto of_material = HasSubstr("warning: binder: Poisson's ratio is -0.1");
  const auto of_stage = HasSubstr("warning: B: its smallest particles, 2 mm, are no wider than the largest of");
  EXPECT_THAT(study.breccia("check").output, AllOf(of_material, of_stage));
  const auto run = study.breccia("run");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.output, AllOf(of_material, of_stage));
  const auto record = Json::parse(read_text(study.result("study.json")));
  EXPECT_THAT(record["stages"][0]["warnings"][0].get<std::string>(), HasSubstr("binder: Poisson's ratio is -0.1"));
  EXPECT_THAT(record["stages"][1]["warnings"][0].get<std::string>(), HasSubstr("B: its smallest particles, 2 mm"));
  EXPECT_THAT(read_text(study.result("report.html")), HasSubstr("B: its smallest particles, 2 mm"));
}

TEST(DeckWarnings, NameAMeasurementThatIsNotCompared) {
  const StudyDirectory study(two_stages() + R"(
[[measurements]]
name  = "rheometer"
stage = "A"
shear = { curve = "G.csv" }
)");
  study.write("G.csv", "time_s,modulus_Pa\n10,2e5\n100,1e5\n");
  const auto line =
      HasSubstr(R"(warning: A: the measurement "rheometer" is not compared: it is known from 10 s to 100 s,)"
                " and tests.times go from 1 ms to 50 ms\n");
  EXPECT_THAT(study.breccia("check").output, line);
  const auto run = study.breccia("run");
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.output, line);
}

// Four discs of 2 mm in 36 mm^2 fill pi / 9, and one in the rest pi / 36; densities of 1.5 and 1 g/cm^3.
TEST(DeckWarnings, ThePlanShowsTheFillerOfTheWhole) {
  const StudyDirectory study(two_stages());
  const auto line = HasSubstr("B: filler of the whole: 40.6 % by volume, 50.6 % by mass\n");
  const auto check = study.breccia("check");
  EXPECT_THAT(check.output, AllOf(line, Not(HasSubstr("A: filler of the whole"))));
  EXPECT_THAT(check.output, HasSubstr("    Poisson  0.30343 at 1 ms, 0.49832 at 50 ms\n"));
  const auto run = study.breccia("run");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.output, line);
  const auto record = Json::parse(read_text(study.result("study.json")));
  const double first = M_PI / 9.0, both = 1.0 - (1.0 - first) * (1.0 - M_PI / 36.0);
  EXPECT_NEAR(record["stages"][0]["filler_of_the_whole"]["fraction"].get<double>(), first, 1e-12);
  const auto whole = record["stages"][1]["filler_of_the_whole"];
  EXPECT_NEAR(whole["fraction"].get<double>(), both, 1e-12);
  EXPECT_NEAR(whole["mass_fraction"].get<double>(), 1.5 * both / (1.0 + 0.5 * both), 1e-12);
  EXPECT_EQ(whole["materials"][0]["material"], "particle");
}

// The filler is 80 %, with coarse to fine 70:30 and fine particles below 10 um.
TEST(StagesCommand, DividesATableOfSizes) {
  const TemporaryDirectory directory;
  directory.write("sizes.csv", "diameter_m,cumulative_volume_fraction\n1e-6,0\n10e-6,0.3\n100e-6,1\n");
  for (const auto* fraction : {"0.8", "80 %"}) {
    const auto stages = run_breccia(directory.path(), {"stages", "sizes.csv", "--fraction", fraction, "--at", "10 um"});
    EXPECT_EQ(stages.exit_code, 0) << stages.errors;
    EXPECT_THAT(stages.output, AllOf(HasSubstr("fraction = 0.5455, from = \"1 um\", to = \"10 um\"    # 30.0 % of"),
                                     HasSubstr("fraction = 0.5600, from = \"10 um\", to = \"100 um\"")));
  }
  const auto bad = run_breccia(directory.path(), {"stages", "sizes.csv", "--fraction", "most", "--at", "10 s"});
  EXPECT_EQ(bad.exit_code, 2);
  EXPECT_THAT(bad.errors, AllOf(HasSubstr("--fraction: expected a number between 0 and 1"),
                                HasSubstr("--at: expected a length, got \"10 s\"")));
  const auto outside = run_breccia(directory.path(), {"stages", "sizes.csv", "--fraction", "0.8", "--at", "1 mm"});
  EXPECT_EQ(outside.exit_code, 2);
  EXPECT_EQ(outside.errors, "--at: expected rising diameters above 1 um and below 100 um, got \"1 mm\"\n");
  const auto refusal = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"stages", "sizes.csv"});
    const auto outcome = run_breccia(directory.path(), options);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.output;
    EXPECT_EQ(outcome.output, "");
    return outcome.errors;
  };
  EXPECT_EQ(refusal({"--fraction", "94", "--at", "10 um"}),
            "--fraction: expected a number between 0 and 1, or per cent as in \"94 %\", got \"94\"\n");
  EXPECT_EQ(refusal({"--fraction", "0.8", "--at", "10 um", "--from", "-2 um", "--to", "0 um"}),
            "--from: expected a positive length, got \"-2 um\"\n--to: expected a positive length, got \"0 um\"\n");
  EXPECT_EQ(refusal({"--fraction", "0.8", "--at", "200 um", "--from", "150 um", "--to", "300 um"}),
            "stages: there are no particles from 150 um to 200 um\n");
}

TEST(DeckWarnings, TheGapIsShownWithItsSource) {
  const StudyDirectory study(good_deck);
  const auto shown = [&](const std::string& gap) {
    return study.breccia("check", {"--set", "stages.A.filler.gap=" + gap}).output;
  };
  EXPECT_THAT(shown("0.12 mm"), HasSubstr("    gap      120 um (1.2 cells of 100 um)\n"));
  EXPECT_THAT(shown("3 points"), HasSubstr("    gap      150 um (1.5 cells of 100 um, from 3 points): it depends on "
                                           "the grid; other cells give another gap"));
  EXPECT_THAT(shown("12 %"), HasSubstr("    gap      120 um (1.2 cells of 100 um, 12 % of the smallest diameter)\n"));
  study.write("deck.toml", replaced(std::string(good_deck), ", gap = \"0.1 mm\"", ""));
  EXPECT_THAT(study.breccia("check").output, HasSubstr("the default of 10 % of the smallest diameter)\n"));
  EXPECT_THAT(study.breccia("pack").output, HasSubstr(", gap 100 um (1 cell of 100 um, the default of 10 %"));
}

TEST(DeckWarnings, TheSizesAreShownAsTheyWereUnderstood) {
  const StudyDirectory study(good_deck);
  const auto shown = [&](const std::string& sizes) {
    study.write("deck.toml", replaced(std::string(good_deck), "sizes = { diameter = \"1 mm\" }", sizes));
    const auto check = study.breccia("check");
    EXPECT_EQ(check.exit_code, 0) << check.errors;
    return check.output;
  };
  EXPECT_THAT(
      shown(R"(sizes = { fuller = "2 mm" }, from = "0.5 mm")"),
      HasSubstr("    sizes    Fuller's curve to 2 mm, exponent 0.5, cut to 500 um .. 2 mm (50 % of the volume)\n"));
  EXPECT_THAT(shown(R"(sizes = { rosin_rammler = "1 mm", exponent = 1.2 }, from = "0.5 mm", to = "2 mm")"),
              HasSubstr("    sizes    Rosin and Rammler, 63.2 % below 1 mm, exponent 1.2, cut to 500 um .. 2 mm "
                        "(54.7 % of the volume)\n"));
  EXPECT_THAT(shown(R"(sizes = { d10 = "0.6 mm", d50 = "1 mm", d90 = "1.5 mm" }, from = "0.5 mm", to = "2 mm")"),
              HasSubstr("    sizes    d10 600 um, d50 1 mm, d90 1.5 mm, lognormal between and beyond them, cut to"));
  EXPECT_THAT(shown(R"(sizes = { from = "0.5 mm", to = "2 mm" })"),
              HasSubstr("    sizes    equal volumes in equal ratios of the diameter, cut to 500 um .. 2 mm\n"));
  EXPECT_THAT(shown(R"(sizes = { passing = [{ size = "0.5 mm", passing = 0 }, { size = "1 mm", passing = "40 %" },
  { size = "2 mm", passing = 1 }] })"),
              HasSubstr("    sizes    a table of 3 rows, cut to 500 um .. 2 mm\n"));
}

TEST(DeckWarnings, ASweepOverCellsWithAGapInPoints) {
  const StudyDirectory study(replaced(std::string(good_deck), "0.1 mm", "2 points"));
  const std::vector<std::string> cells = {"--sweep", "stages.A.cells=[40, 60]"};
  const auto warning = HasSubstr(
      "warning: A: the gap between particles is given in points and follows the grids of this sweep, from 100 um to "
      "150 um");
  EXPECT_THAT(study.breccia("check", cells).output, warning);
  const auto pack = study.breccia("pack", cells);
  EXPECT_EQ(pack.exit_code, 0) << pack.errors;
  EXPECT_THAT(pack.output, warning);
  EXPECT_THAT(read_text(study.result("cells-40/study.json")), HasSubstr("follows the grids of this sweep"));
  EXPECT_THAT(study.breccia("check", {"--sweep", "stages.A.packing.seed=[1, 2]"}).output,
              Not(HasSubstr("of this sweep")));
  study.write("deck.toml", good_deck);
  EXPECT_THAT(study.breccia("check", cells).output, Not(HasSubstr("of this sweep")));
}

TEST(DeckWarnings, APeriodicMicrostructureIsReadBackToTheSameBits) {
  auto deck = replaced(std::string(good_deck), "walls = true", "walls = false");
  deck = replaced(deck, "cells   = 60", "cells   = 20");
  const StudyDirectory packed(deck);
  ASSERT_EQ(packed.breccia("run").exit_code, 0);
  const auto curves = read_text(packed.result("curves.csv"));
  EXPECT_THAT(curves, AllOf(HasSubstr(",periodic,"), Not(HasSubstr(",displacement,"))))
      << "the default where walls = false";

  deck = replaced(deck, R"(, fraction = 0.5, sizes = { diameter = "1 mm" }, gap = "0.1 mm")", "");
  deck = replaced(deck, R"("lubachevsky-stillinger", walls = false, seed = 1)",
                  R"("explicit", discs = "microstructure.csv", walls = false)");
  const StudyDirectory read(deck);
  read.write("microstructure.csv", read_text(packed.result("A/microstructure.csv")));
  const auto run = read.breccia("run");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_EQ(read_text(read.result("curves.csv")), curves);
  EXPECT_THAT(read.breccia("check").output, HasSubstr("discs, periodic\n"));
  EXPECT_THAT(read.breccia("check", {"--set", "stages.A.packing.walls=true"}).errors, HasSubstr("crosses a wall"));
}

TEST(DeckWarnings, BoundariesThatCutPeriodicParticlesAreOnlyUsedOnRequest) {
  const StudyDirectory study(replaced(std::string(good_deck), "walls = true", "walls = false"));
  EXPECT_THAT(study.breccia("check").output, Not(HasSubstr("cut filler")));
  EXPECT_THAT(study.breccia("check", {"--set", R"(tests.boundaries=["displacement", "periodic"])"}).output,
              HasSubstr("warning: A: the sides of the box cut filler, over "));
}

// A window in a larger body: the packing of the periodic box, and bounds in their order.
TEST(DeckWarnings, AWindowHasBoundsOfItsPeriodicModulus) {
  const StudyDirectory study(replaced(std::string(good_deck), "walls = true", "walls = \"cut\""));
  const auto check = study.breccia("check").output;
  EXPECT_THAT(check, AllOf(HasSubstr("Lubachevsky-Stillinger, periodic, seed 1"),
                           HasSubstr("boundary displacement, traction\n"),
                           HasSubstr("warning: A: the sides of the box cut filler, over ")));
  const auto run = study.breccia("run");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.output, HasSubstr("A, this box: bounds "));

  // The order is a theorem right after the step: Hazanov and Huet (1994).
  const auto first_modulus = [](const std::string& boundary) {
    const StudyDirectory one(replaced(std::string(good_deck), "walls = true", "walls = false"));
    const auto with = one.breccia("run", {"--set", "tests.boundaries=[\"" + boundary + "\"]"});
    EXPECT_EQ(with.exit_code, 0) << with.errors;
    return read_curve(one.result("curves.csv"), "A", "shear").front().modulus;
  };
  const double most = first_modulus("displacement"), least = first_modulus("traction");
  EXPECT_THAT(first_modulus("periodic"), AllOf(testing::Gt(1.001 * least), testing::Lt(0.999 * most)));
}

TEST(DeckWarnings, BytesThatAreNotPrintableStayOffTheTerminal) {
  const StudyDirectory study(replaced(std::string(good_deck), R"("lubachevsky-stillinger", walls = true, seed = 1)",
                                      R"("explicit", discs = "grains.png")"));
  study.write("grains.png", "\x89PNG\r\n\x1a\n\x1b[31m");
  const auto check = study.breccia("check");
  EXPECT_EQ(check.exit_code, 2);
  EXPECT_THAT(check.errors, HasSubstr("packing.discs: expected a CSV file with columns x_m, y_m, diameter_m, got "));
  EXPECT_THAT(check.errors, AllOf(Not(HasSubstr("\x1a")), Not(HasSubstr("\x1b"))));
}

}  // namespace
}  // namespace breccia::test
