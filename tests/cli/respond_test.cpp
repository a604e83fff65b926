// Tests of `breccia respond` against runs with the other matrix: it gives their curves at any temperature without
// another solution.

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/text_file.hpp"
#include "study_directory.hpp"
#include "tables/csv.hpp"

namespace breccia::test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::json;

/// A binder that relaxes from 1 GPa over fourteen decades and then flows, and two stages of particles in it.
constexpr std::string_view chain = R"(title = "Chain"

[materials.binder]
density = "1 g/cm^3"
bulk    = "3 GPa"
shear   = { terms = [
  { time = "1 ns", modulus = "600 MPa" }, { time = "100 ns", modulus = "300 MPa" }, { time = "10 us", modulus = "80 MPa" },
  { time = "1 ms", modulus = "10 MPa" }, { time = "100 ms", modulus = "2 MPa" }, { time = "10 s", modulus = "1 MPa" },
  { time = "1000 s", modulus = "0.5 MPa" }, { time = "100000 s", modulus = "0.3 MPa" }] }
temperature_shift = { law = "wlf", c1 = 14.0, c2 = "120 K", reference = "20 degC", temperature = "20 degC" }

[materials.particle]
density = "2 g/cm^3"
bulk    = "40 GPa"
shear   = "30 GPa"

[[stages]]
name    = "fine"
matrix  = "binder"
box     = "6 mm"
cells   = 16
filler  = { material = "particle", sizes = { diameter = "2 mm" } }
packing = { method = "regular", columns = 2, rows = 2 }

[[stages]]
name    = "coarse"
matrix  = "fine"
box     = "60 mm"
cells   = 16
filler  = { material = "particle", sizes = { diameter = "20 mm" } }
packing = { method = "regular", columns = 2, rows = 2 }

[tests]
loads = ["shear"]
times  = ["1 ms", "1 s"]
fields = "none"
)";

using Key = std::tuple<std::string, std::string, std::string, double>;  // stage, load, boundary, time

std::map<Key, double> moduli_in(const std::filesystem::path& curves) {
  const auto table = read_csv(curves, {"stage", "load", "boundary", "method", "cells"});
  std::map<Key, double> moduli;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    moduli[{table.text("stage")[i], table.text("load")[i], table.text("boundary")[i], table.numbers("time_s")[i]}] =
        table.numbers("modulus_Pa")[i];
  }
  return moduli;
}

double largest_difference(const std::map<Key, double>& found, const std::map<Key, double>& expected) {
  EXPECT_EQ(found.size(), expected.size());
  double largest = 0.0;
  for (const auto& [key, modulus] : expected) {
    const auto same = found.find(key);
    EXPECT_NE(same, found.end());
    if (same != found.end()) largest = std::max(largest, std::abs(same->second / modulus - 1.0));
  }
  return largest;
}

class Respond : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    study = std::make_unique<StudyDirectory>(chain);
    const auto run = study->breccia("run");
    ASSERT_EQ(run.exit_code, 0) << run.errors;
  }
  static void TearDownTestSuite() { study.reset(); }

  static Outcome respond(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"respond", "out"});
    return run_breccia(study->path(), arguments);
  }

  static std::unique_ptr<StudyDirectory> study;
};

std::unique_ptr<StudyDirectory> Respond::study;

TEST_F(Respond, AgreesWithRunsAtOtherTemperatures) {
  const auto answered = respond({"--temperature", "-40 degC", "--temperature", "0 degC", "--temperature", "313.15 K",
                                 "--temperature", "80 degC"});
  ASSERT_EQ(answered.exit_code, 0) << answered.errors;
  const std::map<std::string, std::string> directories = {{"-40 degC", "respond-minus40degC"},
                                                          {"0 degC", "respond-0degC"},
                                                          {"40 degC", "respond-40degC"},
                                                          {"80 degC", "respond-80degC"}};
  for (const auto& [temperature, directory] : directories) {
    EXPECT_THAT(answered.output, HasSubstr("with binder at " + temperature));
    const StudyDirectory other(chain);
    const auto run = other.breccia("run", {"--set", "materials.binder.temperature_shift.temperature=" + temperature});
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    const double difference =
        largest_difference(moduli_in(study->result(directory + "/curves.csv")), moduli_in(other.result("curves.csv")));
    RecordProperty("largest difference at " + temperature, std::to_string(difference));
    EXPECT_LT(difference, 1e-4) << temperature;
  }
}

TEST_F(Respond, AnswersTheTemperatureOfTheRunWithTheRun) {
  const auto same = respond({"--temperature", "20 degC", "--out", "same"});
  ASSERT_EQ(same.exit_code, 0) << same.errors;
  EXPECT_LT(largest_difference(moduli_in(study->path() / "same/curves.csv"), moduli_in(study->result("curves.csv"))),
            1e-9);
}

TEST_F(Respond, AStageAtATemperatureIncludesTheStagesThatItBuildsOn) {
  const auto coarse = respond({"--temperature", "30 degC", "--stage", "coarse", "--out", "coarse"});
  ASSERT_EQ(coarse.exit_code, 0) << coarse.errors;
  EXPECT_THAT(coarse.output, HasSubstr("\nfine\n"));
  const auto fine = respond({"--temperature", "30 degC", "--stage", "fine", "--out", "fine"});
  ASSERT_EQ(fine.exit_code, 0) << fine.errors;
  EXPECT_THAT(fine.output, Not(HasSubstr("coarse\n")));
}

TEST_F(Respond, RefusesInvalidTemperatures) {
  study->write("binder.toml", "density = \"1 g/cm^3\"\nbulk = \"3 GPa\"\nshear = \"1 MPa\"\n");
  const std::vector<std::pair<std::vector<std::string>, std::string>> mistakes = {
      {{"--temperature", "40"}, R"(--temperature: expected a temperature with its unit, such as "19 degC", got "40")"},
      {{"--temperature", "40 s"}, R"(--temperature: expected a temperature, got "40 s")"},
      {{"--temperature", "warm"}, R"(got "warm")"},
      {{"--temperature", "-400 degC"}, "expected a temperature above absolute zero"},
      {{"--temperature", "-120 degC"}, "the shift law has no meaning at or below"},
      {{"--temperature", "40 degC", "--temperature", "313.15 K"}, "40 degC is given twice"},
      {{"--temperature", "40 degC", "--material", "binder.toml"}, "either --material FILE.toml or --temperature"},
      {{"--temperature", "40 degC", "--stage", "medium"}, R"(no response of a stage "medium")"},
      {{}, "either --material FILE.toml or --temperature"}};
  for (const auto& [arguments, message] : mistakes) {
    const auto outcome = respond(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << message;
    EXPECT_THAT(outcome.errors, HasSubstr(message));
  }
  // All mistakes are reported at once, and no file is written.
  const auto several =
      respond({"--temperature", "41 degC", "--temperature", "-110 degC", "--temperature", "-130 degC"});
  EXPECT_EQ(several.exit_code, 2);
  EXPECT_THAT(several.errors, HasSubstr("at -110 degC"));
  EXPECT_THAT(several.errors, HasSubstr("at -130 degC"));
  EXPECT_FALSE(std::filesystem::exists(study->result("respond-41degC")));
}

TEST_F(Respond, ReportsTheCoveredTimes) {
  // 10 GPa / (1 + t / 1 us) at s = 1/t is more than 1.05 times the unrelaxed 993.8 MPa of the binder before 8.58 us.
  study->write("stiff.toml", R"(density = "1 g/cm^3"
bulk    = "3 GPa"
shear   = { terms = [{ time = "1 us", modulus = "10 GPa" }] }
)");
  const std::vector<std::string> asked = {"--material", "stiff.toml", "--stage", "fine", "--out", "stiff", "--times"};
  auto wide = asked;
  wide.insert(wide.end(), {"1 us", "100 us"});
  const auto refused = respond(wide);
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.errors, HasSubstr("from 1 us to 100 us stiff shows a shear modulus from 99 MPa to 5 GPa; the "
                                        "responses hold from"));
  EXPECT_THAT(refused.errors, HasSubstr("a new study with this material as its matrix covers all of it"));
  EXPECT_THAT(refused.errors, HasSubstr("covered from 8.7 us to 100 us: --times \"8.7 us\" \"100 us\""));
  EXPECT_FALSE(std::filesystem::exists(study->path() / "stiff"));
  auto covered = asked;
  covered.insert(covered.end(), {"8.7 us", "100 us"});
  EXPECT_EQ(respond(covered).exit_code, 0);
}

TEST_F(Respond, WarnsOfTimesBeyondTheSpectrumOfTheNewMatrix) {
  study->write("short.toml", R"(density = "1 g/cm^3"
bulk    = "3 GPa"
shear   = { equilibrium = "1 MPa", terms = [{ time = "1 ms", modulus = "20 MPa" }, { time = "10 ms", modulus = "10 MPa" }] }
)");
  for (const std::vector<std::string>& stages : {std::vector<std::string>{}, {"--stage", "fine"}}) {
    std::vector<std::string> asked = {"--material", "short.toml", "--times", "1 ms", "1 s", "--overwrite"};
    asked.insert(asked.end(), stages.begin(), stages.end());
    const auto outcome = respond(asked);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
    EXPECT_THAT(outcome.output,
                HasSubstr("warning: fine: times end at 1 s, more than a decade after the slowest relaxation time"));
  }
}

// The warning about particles that are few cells apart holds for any binder; that about the spectrum of the deck's
// binder does not.
TEST(RespondToAWarnedRun, RepeatsTheWarningsOfTheRunOnce) {
  const StudyDirectory study(chain);
  const auto run = study.breccia("run", {"--set", "stages.*.cells=6", "--set", "tests.fit_tolerance=0.5", "--set",
                                         R"(tests.times=["1 ms", "100 Ms"])", "--set", "tests.mixing=series"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const auto record = Json::parse(read_text(study.result("study.json")));
  const auto of_run = record["stages"][0]["warnings"].get<std::vector<std::string>>();
  const std::string gap = "fine: the smallest gap between particles or to a wall";
  const std::string times = "fine: times end at";
  ASSERT_THAT(of_run, Contains(HasSubstr(gap)));
  ASSERT_THAT(of_run, Contains(HasSubstr(times)));
  study.write("slow.toml", R"(density = "1 g/cm^3"
bulk    = "3 GPa"
shear   = { equilibrium = "1 MPa", terms = [{ time = "100 Ms", modulus = "20 MPa" }, { time = "1 ms", modulus = "10 MPa" }] }
)");
  const auto slow = run_breccia(study.path(), {"respond", "out", "--material", "slow.toml"});
  ASSERT_EQ(slow.exit_code, 0) << slow.errors;
  EXPECT_THAT(slow.output, HasSubstr("warning: " + gap));
  EXPECT_THAT(slow.output, Not(HasSubstr(times)));
  const auto twice =
      run_breccia(study.path(), {"respond", "out", "--temperature", "21 degC", "--temperature", "22 degC"}).output;
  const auto first = twice.find(gap);
  ASSERT_NE(first, std::string::npos);
  EXPECT_EQ(twice.find(gap, first + 1), std::string::npos);
}

// A folder that is no stage of the study is none of its results.
TEST_F(Respond, LeavesAsideACopyOfAStage) {
  study->write("aged.toml", "density = \"1 g/cm^3\"\nbulk = \"3 GPa\"\nshear = \"1 MPa\"\n");
  std::filesystem::copy(study->result("fine"), study->result("fine-old"));
  for (const std::vector<std::string>& asked :
       {std::vector<std::string>{"--material", "aged.toml"}, {"--temperature", "40 degC"}}) {
    auto with_place = asked;
    with_place.insert(with_place.end(), {"--out", "beside-a-copy", "--overwrite"});
    const auto outcome = respond(with_place);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
    EXPECT_THAT(read_text(study->path() / "beside-a-copy" / "curves.csv"), Not(HasSubstr("fine-old")));
  }
  std::filesystem::remove_all(study->result("fine-old"));
}

TEST_F(Respond, RefusesADeckInPlaceOfAMaterialInOneLine) {
  study->write("deck-like.toml", "[materials.binder]\ndensity = \"1 g/cm^3\"\nbulk = \"3 GPa\"\nshear = \"1 MPa\"\n");
  const auto outcome = respond({"--material", "deck-like.toml", "--out", "not-there"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.errors, HasSubstr("deck-like.toml:1:"));
  EXPECT_THAT(outcome.errors,
              HasSubstr("materials: expected the keys of one material, density, shear and so on, as a deck "
                        "has them below [materials.NAME], without this line"));
  EXPECT_EQ(std::ranges::count(outcome.errors, '\n'), 1) << outcome.errors;
}

TEST_F(Respond, DoesNotWriteOverTheMaterialItReads) {
  study->write("curves.csv", "density = \"1 g/cm^3\"\nbulk = \"3 GPa\"\nshear = \"1 MPa\"\n");
  const auto outcome = respond({"--material", "curves.csv", "--out", "."});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.errors, HasSubstr("the results would replace this file, from which they come"));
  EXPECT_THAT(read_text(study->path() / "curves.csv"), HasSubstr("density"));
}

TEST_F(Respond, ReplacesCurvesOfAnotherOriginOnlyWhenAsked) {
  const std::vector<std::string> at_30 = {"--temperature", "30 degC", "--out", "same"};
  std::vector<std::string> at_31 = {"--temperature", "31 degC", "--out", "same"};
  std::filesystem::remove_all(study->path() / "same");
  ASSERT_EQ(respond(at_30).exit_code, 0);
  EXPECT_EQ(respond(at_30).exit_code, 0) << "of the same origin";
  const auto curves = read_text(study->path() / "same/curves.csv");
  const auto refused = respond(at_31);
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(
      refused.errors,
      HasSubstr(
          "same: here is what `breccia respond` made of \"binder at 30 degC: fine, coarse from 1 ms to 1 s, study "));
  EXPECT_EQ(read_text(study->path() / "same/curves.csv"), curves);
  at_31.emplace_back("--overwrite");
  EXPECT_EQ(respond(at_31).exit_code, 0);
  EXPECT_NE(read_text(study->path() / "same/curves.csv"), curves);
}

TEST(SweepOverTemperatures, IsOneRun) {
  const StudyDirectory study(chain);
  const auto sweep = study.breccia(
      "run", {"--sweep", R"(materials.binder.temperature_shift.temperature=["20 degC", "-40 degC", "60 degC"])"});
  ASSERT_EQ(sweep.exit_code, 0) << sweep.errors;
  EXPECT_THAT(sweep.output, HasSubstr("coarse: computed from the reduced responses of task temperature-20-degC, at "
                                      "another temperature, without field maps\n"));
  for (const std::string temperature : {"-40 degC", "60 degC"}) {
    const StudyDirectory single(chain);
    const auto run = single.breccia("run", {"--set", "materials.binder.temperature_shift.temperature=" + temperature});
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    const auto task = temperature.front() == '-' ? "temperature-minus-40-degC" : "temperature-60-degC";
    EXPECT_LT(largest_difference(moduli_in(study.result(std::string(task) + "/curves.csv")),
                                 moduli_in(single.result("curves.csv"))),
              1e-4);
    const auto record = Json::parse(read_text(study.result(std::string(task) + "/study.json")));
    EXPECT_EQ(record["complete"], true);
    EXPECT_EQ(record["stages"][1]["answered_from"], "temperature-20-degC");
    EXPECT_EQ(run_breccia(study.path(), {"report", std::string("out/") + task}).exit_code, 0);
  }
}

TEST(SweepOverTemperatures, RunsEachTaskOfADeckThatListsTimesOfFields) {
  const StudyDirectory study(chain);
  const auto sweep = study.breccia("run", {"--set", R"(tests.fields=["1 s"])", "--set", "stages.*.cells=6", "--sweep",
                                           R"(materials.binder.temperature_shift.temperature=["20 degC", "60 degC"])"});
  ASSERT_EQ(sweep.exit_code, 0) << sweep.errors;
  for (const auto* task : {"temperature-20-degC", "temperature-60-degC"}) {
    EXPECT_TRUE(std::filesystem::exists(study.result(std::string(task) + "/fine/fields.vtkhdf"))) << task;
  }
}

TEST(RespondToTimes, ARunThatSampledItsTimesAloneSaysHowToCoverMore) {
  const StudyDirectory study(chain);
  const auto run = study.breccia("run", {"--set", "tests.quasistatic.range=times"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const auto cold = run_breccia(study.path(), {"respond", "out", "--temperature", "-40 degC"});
  EXPECT_EQ(cold.exit_code, 2);
  EXPECT_THAT(cold.errors, HasSubstr("at -40 degC: stage fine: from 1 ms to 1 s binder at -40 degC shows a shear"));
  EXPECT_THAT(cold.errors, HasSubstr("tests.quasistatic.range = \"times\"; with \"matrix\", the default, it covers"));
  const auto test = Json::parse(read_text(study.result("study.json")))["stages"][0]["tests"][0];
  EXPECT_EQ(test["range"], "times");
}

TEST(RespondWithoutLaw, WarnsThatAnElasticMatrixIsTheSameAtAllTemperatures) {
  auto deck = std::string(chain);
  const auto shear = deck.find("shear   = { terms"), end = deck.find("[materials.particle]");
  deck.replace(shear, end - shear, "shear   = \"1 GPa\"\n\n");
  const StudyDirectory study(deck);
  const auto run = study.breccia("run", {"--set", "stages.*.cells=6"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const auto outcome = run_breccia(study.path(), {"respond", "out", "--temperature", "40 degC"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output,
              HasSubstr("warning: binder is elastic: its moduli do not depend on the temperature here"));
}

TEST(RespondWithoutLaw, AsksForAMaterial) {
  auto deck = std::string(chain);
  const auto law = deck.find("temperature_shift");
  deck.erase(law, deck.find('\n', law) - law);
  const StudyDirectory study(deck);
  ASSERT_EQ(study.breccia("run", {"--set", "stages.*.cells=6"}).exit_code, 0);
  const auto outcome = run_breccia(study.path(), {"respond", "out", "--temperature", "40 degC"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.errors, HasSubstr("binder has no temperature_shift in the deck of the study"));
  std::filesystem::remove(study.result("study.json"));
  const auto lost = run_breccia(study.path(), {"respond", "out", "--temperature", "40 degC"});
  EXPECT_EQ(lost.exit_code, 2);
  EXPECT_THAT(lost.errors, HasSubstr("out: no study.json, which a run writes after its first test"));
}

}  // namespace
}  // namespace breccia::test
