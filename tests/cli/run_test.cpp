#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "good_deck.hpp"
#include "io/text_file.hpp"
#include "messages.hpp"
#include "model_deck.hpp"
#include "scoped_variable.hpp"
#include "study_directory.hpp"
#include "tables/csv.hpp"

namespace breccia {
namespace {

using test::homogeneous_deck;
using test::model_deck;
using test::modulus_at;
using test::read_curve;
using test::StudyDirectory;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// Quasi-static values of the model composite from an independent computation with standard points.
struct Known {
  double time;
  double modulus;
};
constexpr std::array<Known, 5> known_standard_24 = {
    {{1e-3, 0.884355e6}, {3e-3, 0.744429e6}, {1e-2, 0.419205e6}, {3e-2, 0.118464e6}, {5e-2, 0.0636499e6}}};
constexpr std::array<Known, 5> known_standard_48 = {
    {{1e-3, 0.841164e6}, {3e-3, 0.705966e6}, {1e-2, 0.392194e6}, {3e-2, 0.102588e6}, {5e-2, 0.0491607e6}}};

void expect_quasi_static(const Curve& curve, const std::array<Known, 5>& known, double tolerance) {
  for (const auto& [time, modulus] : known) {
    EXPECT_NEAR(modulus_at(curve, time) / modulus, 1.0, tolerance) << "at " << time << " s";
  }
}

/// A stage of four particles, and one of four larger ones in its composite.
std::string two_stages() {
  auto deck = test::replaced(std::string(test::good_deck), "name    = \"A\"", "name    = \"fine\"");
  deck = test::replaced(deck, "\"6 mm\"", "\"3 mm\"");
  deck = test::replaced(deck, "cells   = 60", "cells   = 24");
  deck = test::replaced(deck, "fraction = 0.5", "fraction = 0.35");
  deck = test::replaced(deck, "walls = true", "walls = false");
  deck = test::replaced(deck, "shear   = { terms", "shear   = { equilibrium = \"0.1 MPa\", terms");
  return test::replaced(deck, "[tests]", R"([[stages]]
name    = "coarse"
matrix  = "fine"
box     = "60 mm"
cells   = 24
filler  = { material = "hmx", fraction = 0.35, sizes = { diameter = "20 mm" }, gap = "2 mm" }
packing = { method = "lubachevsky-stillinger", walls = false, seed = 1 }

[tests])");
}

void expect_exact(const Curve& curve, double constant, double relaxing) {
  EXPECT_EQ(curve.front().time, 1e-3);
  EXPECT_EQ(curve.back().time, 50e-3);
  for (const auto& [time, modulus] : curve) {
    EXPECT_NEAR(modulus / (constant + relaxing * std::exp(-time / 10e-3)), 1.0, 1e-3) << "at " << time << " s";
  }
}

TEST(Run, ModelCompositeAgreesWithTheQuasiStaticLimit) {
  const StudyDirectory study(model_deck);
  const auto run = study.breccia("run");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.output, HasSubstr("A: 4 particles fill 34.91 % of the box"));
  EXPECT_THAT(run.output, HasSubstr("Results are in out: open out/report.html\n"));
  expect_quasi_static(read_curve(study.result("curves.csv"), "A", "shear"), known_standard_24, 0.015);
}

TEST(Run, TablesOfFrequenciesHaveTheirDecades) {
  const StudyDirectory study(R"([materials.binder]
density = "1 g/cm^3"
bulk    = "3 GPa"
shear   = { terms = [{ time = "100 ms", modulus = "80 MPa" }], equilibrium = "1 MPa" }
[[stages]]
name = "A"
matrix = "binder"
box = "1 m"
cells = 2
[tests]
loads = ["shear", "bulk"]
boundaries = ["displacement"]
frequencies = ["0.1 Hz", "10 Hz"]
)");
  const auto run = study.breccia("run", {"--verbose"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.output, HasSubstr("dynamic.csv, engineering.csv, engineering_dynamic.csv\n"));
  const auto table = read_csv(study.result("engineering_dynamic.csv"),
                              {"stage", "boundary", "method", "cells", "youngs_modulus_error"});
  const auto& omega = table.numbers("angular_frequency_rad_per_s");
  ASSERT_EQ(omega.size(), 41U);  // twenty frequencies a decade
  constexpr double per_cycle = 2.0 * std::numbers::pi;
  EXPECT_NEAR(omega.front() / (0.1 * per_cycle), 1.0, 1e-14);
  EXPECT_NEAR(omega[20] / per_cycle, 1.0, 1e-14);
  EXPECT_NEAR(omega.back() / (10.0 * per_cycle), 1.0, 1e-14);
  const std::complex<double> turn(0.0, 0.1 * per_cycle);  // omega tau of the term at 1 Hz
  const std::complex<double> shear = 1e6 + 80e6 * turn / (1.0 + turn), young = 9.0 * 3e9 * shear / (9e9 + shear);
  EXPECT_NEAR(table.numbers("youngs_storage_modulus_Pa")[20] / young.real(), 1.0, 1e-4);
  EXPECT_NEAR(table.numbers("youngs_loss_modulus_Pa")[20] / young.imag(), 1.0, 1e-4);
  const auto record = nlohmann::json::parse(read_text(study.result("study.json")));
  EXPECT_NEAR(record.at("frequencies_Hz").at(0).get<double>(), 0.1, 1e-15);
  EXPECT_NEAR(record.at("frequencies_Hz").at(1).get<double>(), 10.0, 1e-13);
  // At 1 Hz G = 23.64 + 36.04 i MPa, and E = 9 K G / (3 K + G).
  EXPECT_THAT(run.output,
              HasSubstr("\nA, G, displacement, quasistatic\n   frequency          |G*|      phase            G'"
                        "           G''  tan delta\n"));
  EXPECT_THAT(run.output, HasSubstr("        1 Hz      43.1 MPa   56.7 deg      23.6 MPa        36 MPa       1.52\n"));
  EXPECT_THAT(run.output, HasSubstr("\nA, K + G/3, displacement, quasistatic\n   frequency          |M*|"));
  EXPECT_THAT(run.output,
              HasSubstr("        1 Hz       129 MPa   56.5 deg      71.2 MPa       108 MPa       1.51    0.4960"));
  EXPECT_THAT(run.output, Not(HasSubstr("100 ms"))) << "no table over time";
}

TEST(Run, HomogeneousBoxRelaxesAsItsMaterialUnderBothLoads) {
  const StudyDirectory study(homogeneous_deck);
  const auto run = study.breccia("run", {"--set", R"(tests.loads=["shear", "bulk"])"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  // E = 9 K G / (3 K + G) of the elastic box before it relaxes stands beside both.
  EXPECT_THAT(run.output, HasSubstr("G       K + G/3             E"));
  expect_exact(read_curve(study.result("curves.csv"), "A", "shear"), 0.0, 0.5e6);
  expect_exact(read_curve(study.result("curves.csv"), "A", "bulk"), 1e6, 0.5e6 / 3.0);
}

TEST(Run, StagesAreRunOneAfterTheOther) {
  const StudyDirectory study(std::string(homogeneous_deck) +
                             "[[stages]]\nname = \"B\"\nmatrix = \"binder\"\nbox = \"3 mm\"\ncells = 12\n");
  const auto run = study.breccia("run");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  for (const auto* stage : {"A", "B"}) {
    expect_exact(read_curve(study.result("curves.csv"), stage, "shear"), 0.0, 0.5e6);
    EXPECT_TRUE(std::filesystem::exists(study.result(std::string(stage) + "/modulus.svg")));
  }
}

TEST(Run, ClassicalFormulationGivesTheSameAnswer) {
  const StudyDirectory study(model_deck);
  const std::vector<std::string> small{"--set", "stages.A.cells=8", "--set", R"(tests.times=["1 ms", "10 ms"])"};
  auto classical = small;
  classical.insert(classical.end(), {"--overwrite", "--set", "tests.dynamic.formulation=classical"});
  ASSERT_EQ(study.breccia("run", small).exit_code, 0);
  const auto expected = read_curve(study.result("curves.csv"), "A", "shear");
  ASSERT_EQ(study.breccia("run", classical).exit_code, 0);
  const auto curve = read_curve(study.result("curves.csv"), "A", "shear");
  ASSERT_EQ(curve.size(), expected.size());
  for (std::size_t i = 0; i < curve.size(); ++i) {
    EXPECT_EQ(curve[i].time, expected[i].time);
    EXPECT_NEAR(curve[i].modulus / expected[i].modulus, 1.0, 5e-3) << "at " << curve[i].time << " s";
  }
  EXPECT_THAT(read_text(study.result("study.json")), HasSubstr(R"("formulation": "classical")"));
}

TEST(Run, TheNumberOfThreadsDoesNotChangeABit) {
  const StudyDirectory study(test::replaced(std::string(model_deck), "cells   = 24", "cells   = 64"));
  const std::vector<std::string> short_times{"--set", R"(tests.times=["1 ms", "1.2 ms"])"};
  ASSERT_EQ(study.breccia("run", short_times).exit_code, 0);
  const auto with_one = read_text(study.result("curves.csv"));
  ASSERT_EQ(test::run_breccia(study.path(),
                              {"run", "deck.toml", "--out", "out", "--threads", "2", short_times[0], short_times[1]})
                .exit_code,
            0);
  EXPECT_EQ(read_text(study.result("curves.csv")), with_one);
}

// libgomp prints its settings when it is loaded: those of the program as it was started, and once more after a new
// start.
TEST(Run, ThreadsSleepSoonUnlessTheEnvironmentSaysHowTheyWait) {
  const StudyDirectory study(homogeneous_deck);
  const test::ScopedVariable display("OMP_DISPLAY_ENV", "verbose"), none("GOMP_SPINCOUNT", std::nullopt);
  const auto settings = [&] { return test::run_breccia(study.path(), {"run", "--help"}).errors; };
  {
    const test::ScopedVariable policy("OMP_WAIT_POLICY", std::nullopt);
    if (settings().find("GOMP_SPINCOUNT") == std::string::npos) GTEST_SKIP() << "another OpenMP than libgomp";
    EXPECT_THAT(settings(), HasSubstr("GOMP_SPINCOUNT = '1000'"));
  }
  const test::ScopedVariable policy("OMP_WAIT_POLICY", "active");
  EXPECT_THAT(settings(), Not(HasSubstr("GOMP_SPINCOUNT = '1000'")));
}

// HB-1 is the matrix of the last stage: its table is for those who ask for it. Each warning stands once.
TEST(Run, PrintsAScreenAndMoreOnRequest) {
  const StudyDirectory study(two_stages());
  const auto brief = study.breccia("run").output;
  EXPECT_THAT(
      brief, AllOf(HasSubstr("fine, periodic: 24 cells, "), HasSubstr("\ncoarse\n"), HasSubstr("coarse, this box: "),
                   Not(HasSubstr("\nfine\n")), Not(HasSubstr("fine, this box: ")), Not(HasSubstr("error of the basis")),
                   Not(HasSubstr("microstructure.svg"))));
  const std::string warning = "warning: fine: only 4 particles in the box";
  EXPECT_THAT(brief, HasSubstr(warning));
  EXPECT_EQ(brief.find(warning), brief.rfind(warning));
  const auto full = study.breccia("run", {"--overwrite", "--verbose"}).output;
  EXPECT_THAT(full, AllOf(HasSubstr("fine shear, periodic: 24 cells, "), HasSubstr("\nfine\n"), HasSubstr("\ncoarse\n"),
                          HasSubstr("error of the basis"), HasSubstr("out/fine/microstructure.svg"),
                          HasSubstr("curves.csv, prony.csv, study.json")));
}

TEST(Run, QuietKeepsWarnings) {
  const StudyDirectory study(two_stages());
  const auto run = study.breccia("run", {"--quiet"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.output, "");
  EXPECT_THAT(run.errors, HasSubstr("warning: fine: only 4 particles in the box"));
}

TEST(Run, IsEitherQuietOrVerbose) {
  const StudyDirectory study(homogeneous_deck);
  const auto outcome = study.breccia("run", {"--quiet", "--verbose"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.errors, HasSubstr("--quiet prints less, --verbose more: expected only one of them"));
  EXPECT_THAT(study.results(), testing::IsEmpty());
}

TEST(Run, QuietPrintsNothingMore) {
  const StudyDirectory study(homogeneous_deck);
  for (const auto* command : {"run", "pack"}) {
    const auto outcome = study.breccia(command, {"--quiet", "--set", "stages.A.cells=8"});
    EXPECT_EQ(outcome.exit_code, 0) << command;
    EXPECT_EQ(outcome.output, "") << command;
    EXPECT_EQ(outcome.errors, "") << command;
  }
}

TEST(Run, ResultsGoToADirectoryNamedAfterTheDeck) {
  const StudyDirectory study(homogeneous_deck);
  const auto run = test::run_breccia(study.path(), {"run", "deck.toml", "--set", "stages.A.cells=8"});
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_TRUE(std::filesystem::exists(study.path() / "results" / "deck" / "curves.csv"));
}

// A table of polygons that stayed would list particles that the new box does not have.
TEST(Run, ReplacesTheFilesOfParticlesOfAnotherShape) {
  const StudyDirectory study(test::good_deck);
  study.write("triangle.csv", "x_mm,y_mm\n0,0\n3,0\n1,3\n");
  const auto run = [&study](const std::string& shape) {
    return study.breccia(
        "run",
        {"--set", "stages.A.cells=12", "--set", R"(tests.fields="none")", "--set",
         fmt::format(R"(stages.A.filler={{ material = "hmx", fraction = 0.2, shape = {{ {} }}, )"
                     R"(sizes = {{ diameter = "2 mm" }} }})",
                     shape),
         "--set", R"(stages.A.packing={ method = "random-sequential", walls = true, seed = 1 })", "--overwrite"});
  };
  const std::string triangles = R"(polygon = "triangle.csv")";
  const auto polygons = run(triangles);
  ASSERT_EQ(polygons.exit_code, 0) << polygons.errors;
  EXPECT_THAT(study.results(), AllOf(Contains("A/polygons.csv"), Not(Contains("A/microstructure.csv"))));

  const auto ellipses = run("aspect = 1.5");
  ASSERT_EQ(ellipses.exit_code, 0) << ellipses.errors;
  EXPECT_THAT(study.results(), AllOf(Contains("A/microstructure.csv"), Not(Contains("A/polygons.csv"))));

  const auto once_more = run(triangles);
  ASSERT_EQ(once_more.exit_code, 0) << once_more.errors;
  EXPECT_THAT(study.results(), AllOf(Contains("A/polygons.csv"), Not(Contains("A/microstructure.csv")),
                                     Not(Contains(HasSubstr("unfinished")))));
}

TEST(Examples, ModelCompositeAgreesWithTheQuasiStaticLimit) {
  const test::TemporaryDirectory directory;
  const auto run =
      test::run_breccia(directory.path(), {"run", BRECCIA_EXAMPLES_DIRECTORY "/model-composite.toml", "--out", "."});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  expect_quasi_static(read_curve(directory.path() / "curves.csv", "model", "shear"), known_standard_48, 0.01);
}

/// Each stage of PBX-9501 is stiffer than the one before and softer than its filler, at all times.
void expect_stiffer_stages(const std::filesystem::path& curves) {
  const auto first = read_curve(curves, "HB-1", "shear"), second = read_curve(curves, "HB-2", "shear"),
             composite = read_curve(curves, "PBX-9501", "shear");
  constexpr double hmx = 5.84e9;
  ASSERT_EQ(composite.size(), first.size());
  for (std::size_t i = 0; i < composite.size(); ++i) {
    EXPECT_LT(first[i].modulus, second[i].modulus);
    EXPECT_LT(second[i].modulus, composite[i].modulus);
    EXPECT_LT(composite[i].modulus, hmx);
  }
}

TEST(Examples, Pbx9501StiffensFromStageToStage) {
  const test::TemporaryDirectory directory;
  const std::string deck = BRECCIA_EXAMPLES_DIRECTORY "/pbx9501-quick.toml";
  std::vector<std::string> arguments = {
      "run", deck, "--out", ".", "--set", "tests.method=quasistatic", "--set", R"(tests.boundaries=["traction"])"};
  for (const auto* stage : {"HB-1", "HB-2", "PBX-9501"}) {
    arguments.insert(arguments.end(), {"--set", std::string("stages.") + stage + ".cells=40"});
  }
  const auto run = test::run_breccia(directory.path(), arguments);
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.output, HasSubstr("PBX-9501 over what was measured, Bennett et al. 1998"));
  expect_stiffer_stages(directory.path() / "curves.csv");
}

// The test runs one deck with spheres and, with dimensions = 2, with discs.
TEST(Examples, Pbx9501OfSpheresStiffensFromStageToStage) {
  const std::string deck = BRECCIA_EXAMPLES_DIRECTORY "/pbx9501-3d-quick.toml";
  for (const auto* dimensions : {"3", "2"}) {
    SCOPED_TRACE(dimensions);
    const test::TemporaryDirectory directory;
    const auto run = test::run_breccia(
        directory.path(), {"run", deck, "--out", ".", "--threads", "1", "--set", "tests.fields=none", "--set",
                           "stages.*.cells=10", "--set", std::string("dimensions=") + dimensions});
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    EXPECT_THAT(run.output, HasSubstr("PBX-9501 over what was measured, Bennett et al. 1998"));
    expect_stiffer_stages(directory.path() / "curves.csv");
  }
}

TEST(Examples, TwoFillersHaveTheirStatistics) {
  const test::TemporaryDirectory directory;
  constexpr auto deck = BRECCIA_EXAMPLES_DIRECTORY "/two-fillers.toml";
  const auto run = test::run_breccia(directory.path(), {"run", deck, "--out", ".", "--set", "stages.0.cells=100",
                                                        "--set", R"(tests.boundaries=["traction"])"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.output, HasSubstr("filler 2, aluminium: "));
  const auto record = nlohmann::json::parse(read_text(directory.path() / "study.json"))["stages"][0];
  EXPECT_EQ(record["filler"], "ap, aluminium");
  const auto& fillers = record["fillers"];
  ASSERT_EQ(fillers.size(), 3U);
  double fraction = 0.0;
  for (const auto& filler : fillers) fraction += filler["fraction"].get<double>();
  EXPECT_NEAR(fraction, record["microstructure"]["fraction"].get<double>(), 1e-12);
  // Each fraction is within half a particle of the requested one.
  EXPECT_NEAR(fillers[0]["fraction"].get<double>(), 0.38, 0.016);
  EXPECT_NEAR(fillers[1]["fraction"].get<double>(), 0.17, 0.0032);
  EXPECT_NEAR(fillers[2]["fraction"].get<double>(), 0.12, 0.0007);
  const auto columns = read_csv(directory.path() / "propellant" / "microstructure.csv");
  EXPECT_EQ(columns.names().back(), "filler");
  const auto page = read_text(directory.path() / "report.html");
  EXPECT_THAT(page, HasSubstr("ap, aluminium"));
}

TEST(Examples, AreWithoutMistakes) {
  const test::TemporaryDirectory directory;
  std::size_t decks = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(BRECCIA_EXAMPLES_DIRECTORY)) {
    if (entry.path().extension() != ".toml") continue;
    ++decks;
    std::vector<std::string> arguments = {"check", entry.path().string()};
    // A check packs the boxes for its plan, which takes a minute at the fractions of these decks; and one of them needs
    // 16 GB of memory.
    if (entry.path().stem() == "pbx9501-direct")
      arguments.insert(arguments.end(), {"--set", "stages.0.filler.fraction=0.6"});
    if (entry.path().stem() == "pbx9501-all-sizes")
      arguments.insert(arguments.end(),
                       {"--set", "stages.direct.filler.fraction=0.5", "--set", "stages.direct.cells=1000"});
    // The plan of a dynamic test takes a trial run; those of the first decks are enough.
    if (entry.path().parent_path().stem() == "paper")
      arguments.insert(arguments.end(), {"--set", "tests.method=quasistatic"});
    const auto check = test::run_breccia(directory.path(), arguments);
    EXPECT_EQ(check.exit_code, 0) << entry.path() << "\n" << check.errors;
    EXPECT_THAT(check.output, HasSubstr("plan, ")) << entry.path();
    EXPECT_EQ(check.errors, "") << entry.path();
  }
  EXPECT_GT(decks, 0U);
}

}  // namespace
}  // namespace breccia
