#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/text_file.hpp"
#include "messages.hpp"
#include "model_deck.hpp"
#include "study_directory.hpp"
#include "tables/csv.hpp"

namespace breccia::test {
namespace {

using ::testing::HasSubstr;
using Json = nlohmann::json;

/// A box without particles has the moduli of its matrix, so that it must reproduce the result of the stage before it.
const std::string passing_on = std::string(model_deck) + R"(
[[stages]]
name   = "B"
matrix = "A"
box    = "60 mm"
cells  = 8
)";

using Key = std::tuple<std::string, std::string, std::string>;  // stage, boundary, method

/// G(t) [Pa] of stages by boundary and method.
std::map<Key, std::vector<double>> shear_moduli(const StudyDirectory& study) {
  const auto table = read_csv(study.result("curves.csv"), {"stage", "load", "boundary", "method", "cells"});
  std::map<Key, std::vector<double>> moduli;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (table.text("load")[row] != "shear") continue;
    moduli[{table.text("stage")[row], table.text("boundary")[row], table.text("method")[row]}].push_back(
        table.numbers("modulus_Pa")[row]);
  }
  return moduli;
}

/// Largest relative difference between stage B and stage A.
double worst_difference(const StudyDirectory& study, const std::string& boundary, const std::string& method) {
  const auto moduli = shear_moduli(study);
  const auto& first = moduli.at({"A", boundary, method});
  const auto& second = moduli.at({"B", boundary, method});
  EXPECT_EQ(first.size(), second.size());
  double worst = 0.0;
  for (std::size_t i = 0; i < std::min(first.size(), second.size()); ++i) {
    worst = std::max(worst, std::abs(second[i] / first[i] - 1.0));
  }
  return worst;
}

/// A stage of few discs by both methods, and another that builds on it.
const std::string chain =
    test::replaced(test::replaced(passing_on, R"(method     = "dynamic")", R"(method = ["quasistatic", "dynamic"])"),
                   "cells   = 24", "cells   = 12");

TEST(Stages, OfASweepAreComputedOnceIfTheyAreTheSame) {
  const StudyDirectory sweep(chain), single(chain);
  const auto run = sweep.breccia("run", {"--sweep", "stages.B.cells=[8, 6]"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.output, HasSubstr("\nA: the same as in out/cells-8/A\n"));
  ASSERT_EQ(single.breccia("run", {"--set", "stages.B.cells=6"}).exit_code, 0);
  for (const auto& name : single.results()) {
    EXPECT_TRUE(std::filesystem::exists(sweep.result("cells-6/" + name))) << name;
  }
  for (const auto* file : {"curves.csv", "prony.csv", "A/microstructure.csv", "A/fields.vtkhdf", "A/fields-strain.svg",
                           "A/modulus.svg", "B/modulus.svg"}) {
    EXPECT_EQ(read_text(sweep.result(std::string("cells-6/") + file)), read_text(single.result(file))) << file;
  }
  EXPECT_EQ(test::run_breccia(sweep.path(), {"report", "out/cells-6"}).exit_code, 0) << "all of one study";
}

TEST(Stages, OfASweepThatFailAreTriedOnce) {
  auto deck = test::replaced(chain, "sizes = { diameter = \"2 mm\" }",
                             R"(fraction = 0.85, gap = "0 m", sizes = { diameter = "0.5 mm" })");
  deck = test::replaced(deck, "method = \"regular\", columns = 2, rows = 2",
                        "method = \"lubachevsky-stillinger\", walls = true");
  const StudyDirectory study(deck);
  const auto run = study.breccia("run", {"--sweep", "stages.B.cells=[8, 6]"});
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_THAT(run.errors, testing::AllOf(HasSubstr("cells-8: A: "), HasSubstr("cells-6: A: ")));
}

TEST(Stages, AStageIsTheMatrixUnderTheSameBoundary) {
  StudyDirectory study(passing_on);
  const auto run = study.breccia("run", {"--set", "tests.method=quasistatic", "--set",
                                         R"(tests.boundaries=["displacement", "traction", "periodic"])"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const auto provenance = Json::parse(read_text(study.result("study.json")));
  const auto& passed_on = provenance["stages"][0]["materials"];
  ASSERT_EQ(passed_on.size(), 3U);
  for (const auto& material : passed_on) {
    const double fit_error = material["shear_fit_error"];
    const std::string boundary = material["boundary"];
    EXPECT_LT(fit_error, 0.1 * 0.03) << boundary;  // a tenth of tests.fit_tolerance
    // The bounds themselves are tens of per cent apart.
    EXPECT_LT(worst_difference(study, boundary, "quasistatic"), 2.0 * fit_error + 1e-5) << boundary;
    EXPECT_DOUBLE_EQ(material["material"]["density_kg_per_m3"], 1000.0 + 500.0 * 4.0 * M_PI / 36.0);
  }
  EXPECT_TRUE(provenance["stages"][1]["materials"].empty());
}

TEST(Stages, TheDynamicMethodPassesOnItsOwnResult) {
  StudyDirectory study(passing_on);
  const auto run = study.breccia("run", {"--set", R"(tests.times=["3 ms", "30 ms"])"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_LT(worst_difference(study, "displacement", "dynamic"), 0.02);
}

TEST(Stages, ExtrapolatedResultsArePassedOn) {
  StudyDirectory study(passing_on);
  const auto run = study.breccia("run", {"--set", "tests.method=quasistatic", "--set", "stages.A.cells=[24, 48]"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const auto table = read_csv(study.result("curves.csv"), {"stage", "load", "boundary", "method", "cells"});
  std::map<double, double> extrapolated;
  double worst = 0.0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double time = table.numbers("time_s")[row], modulus = table.numbers("modulus_Pa")[row];
    if (table.text("load")[row] == "bulk") continue;
    if (table.text("cells")[row] == "extrapolated") extrapolated[time] = modulus;
    if (table.text("stage")[row] == "B") worst = std::max(worst, std::abs(modulus / extrapolated.at(time) - 1.0));
  }
  EXPECT_LT(worst, 1e-3);
}

TEST(Stages, ABadFitStopsTheStudyAndKeepsFinishedResults) {
  StudyDirectory study(passing_on);
  const auto run = study.breccia("run", {"--set", "tests.method=quasistatic", "--set", "tests.fit_tolerance=1e-12"});
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_THAT(run.errors, HasSubstr("stage A, displacement, quasistatic: the fit of G(t)"));
  EXPECT_THAT(run.errors, HasSubstr("tests.fit_tolerance"));
  EXPECT_THAT(shear_moduli(study), ::testing::SizeIs(1));
}

TEST(Stages, ARespondingStudyPassesOnItsResults) {
  StudyDirectory study(passing_on);
  const auto run =
      study.breccia("run", {"--set", "tests.method=quasistatic", "--set", R"(tests.boundaries=["traction"])"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  study.write("same.toml", R"(density = "1 g/cm^3"
bulk    = "1 MPa"
shear   = { terms = [{ time = "10 ms", modulus = "0.5 MPa" }] }
)");
  const auto respond = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"respond", "out", "--material", "same.toml"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_breccia(study.path(), arguments);
  };
  const auto same = respond({});
  ASSERT_EQ(same.exit_code, 0) << same.errors;
  const auto before = read_curve(study.result("curves.csv"), "B", "shear");
  const auto after = read_curve(study.result("respond-same/curves.csv"), "B", "shear");
  ASSERT_EQ(after.size(), before.size());
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(after[i].modulus / before[i].modulus, 1.0, 1e-9);

  // A stage by name takes the material itself, for which this one was not sampled.
  const auto alone = respond({"--stage", "B"});
  EXPECT_EQ(alone.exit_code, 2);
  EXPECT_THAT(alone.errors, HasSubstr("stage B: from 1 ms to 50 ms same shows a bulk modulus of 1 MPa"));

  std::filesystem::remove_all(study.result("A"));
  const auto incomplete = respond({});
  EXPECT_EQ(incomplete.exit_code, 2);
  EXPECT_THAT(incomplete.errors, HasSubstr("stage B: its matrix is the result of stage A, of which there is no"));
}

TEST(Stages, MeasurementsStandBesideTheResult) {
  StudyDirectory study(std::string(model_deck) + R"(
[[measurements]]
name  = "a solid"
shear = { prony = "solid.csv" }
[[measurements]]
name  = "points"
shear = { curve = "points.csv" }
times = ["2 ms", "1 s"]
)");
  study.write("solid.csv", "relaxation_time_s,modulus_Pa\ninf,1e5\n");
  // The measurement is a straight line in logarithmic axes: 1e5 Pa (t / 1 ms)^(-1/2).
  study.write("points.csv", "time_s,modulus_Pa\n1e-3,1e5\n0.1,1e4\n");
  const auto run = study.breccia("run", {"--set", "tests.method=quasistatic"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.output, HasSubstr("A over what was measured, a solid"));
  const auto table = read_csv(study.result("comparison.csv"),
                              {"measurement", "modulus", "stage", "boundary", "method", "cells", "error"});
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double time = table.numbers("time_s")[row], measured = table.numbers("measured_Pa")[row];
    const bool is_solid = table.text("measurement")[row] == "a solid";
    EXPECT_NEAR(measured / (is_solid ? 1e5 : 1e5 * std::pow(time / 1e-3, -0.5)), 1.0, 1e-9);
    EXPECT_DOUBLE_EQ(table.numbers("ratio")[row], table.numbers("modulus_Pa")[row] / measured);
    EXPECT_GE(time, is_solid ? 1e-3 : 2e-3);
  }
  const auto comparisons = Json::parse(read_text(study.result("study.json")))["stages"][0]["comparisons"];
  ASSERT_EQ(comparisons.size(), 2U);
  EXPECT_NEAR(comparisons[0]["best"]["ratio"].get<double>(), 1.0, 0.2);
  EXPECT_THAT(read_text(study.result("A/modulus.svg")), HasSubstr("measured, points"));
}

TEST(Stages, MistakesInMeasurementsAreRefusedAtOnce) {
  StudyDirectory study(std::string(model_deck) + R"(
[[measurements]]
name  = "x"
stage = "a"
shear = { curve = "falling.csv" }
times = ["1 s", "1 ms"]
[[measurements]]
name  = "x"
shear = { prony = "none.csv", curve = "falling.csv" }
)");
  study.write("falling.csv", "time_s,modulus_Pa\n2,1\n1,1\n3,-1\n");
  const auto check = study.breccia("check");
  EXPECT_EQ(check.exit_code, 2);
  for (const auto* mistake :
       {R"(measurements.x.stage: unknown stage "a", did you mean "A"?)",
        "falling.csv:3: expected rising positive times", "falling.csv:4: expected a positive modulus, got -1",
        "expected two rising times", R"(another measurement is called "x")", "expected exactly one of prony, curve"}) {
    EXPECT_THAT(check.errors, HasSubstr(mistake));
  }
}

TEST(Stages, ThePlanOfALaterStageIsAGuess) {
  StudyDirectory study(passing_on);
  const auto check = study.breccia("check", {"--set", R"(tests.method=["quasistatic", "dynamic"])"});
  EXPECT_EQ(check.exit_code, 0) << check.errors;
  EXPECT_THAT(check.output, HasSubstr("B displacement, quasi-static"));
  EXPECT_THAT(check.output, HasSubstr("B shear, displacement, dynamic"));
  EXPECT_THAT(check.output, HasSubstr("A bulk, displacement, dynamic"));
}

}  // namespace
}  // namespace breccia::test
