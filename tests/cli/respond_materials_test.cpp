// Tests of `breccia respond --material` with the materials of several phases.

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "coated_discs.hpp"
#include "study_directory.hpp"

namespace breccia::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string elastic(const std::string& shear) {
  return fmt::format("density = \"1.2 g/cm^3\"\nbulk = \"2 GPa\"\nshear = \"{}\"\n", shear);
}

constexpr std::string_view aged = R"(density = "1 g/cm^3"
bulk    = "3 GPa"
shear   = { equilibrium = "2 MPa", terms = [{ time = "1 ms", modulus = "400 MPa" }, { time = "30 ms", modulus = "50 MPa" }] }
)";

class RespondWithMaterials : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    study = std::make_unique<StudyDirectory>(coated_discs);
    const auto run = study->breccia("run", {"--verbose"});
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    output_of_run = run.output;
    study->write("soft.toml", elastic("20 MPa"));
    study->write("stiff.toml", elastic("1 GPa"));
    study->write("rigid.toml", elastic("9 GPa"));
    study->write("aged.toml", aged);
    study->write("broken.toml", "density = \"1\"\n");
  }
  static void TearDownTestSuite() { study.reset(); }

  static Outcome respond(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"respond", "out"});
    return run_breccia(study->path(), arguments);
  }
  /// Compares the curve in a directory with that of a separate run, which samples the matrix alone.
  static void expect_run(const std::string& directory, const std::vector<std::string>& settings) {
    const StudyDirectory other(coated_discs);
    std::vector<std::string> more = {"--set", "tests.quasistatic.vary={}", "--set", "tests.quasistatic.tolerance=1e-6",
                                     "--set", "tests.mixing=series"};
    for (const auto& setting : settings) more.insert(more.end(), {"--set", setting});
    const auto run = other.breccia("run", more);
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    const auto found = read_curve(study->result(directory + "/curves.csv"), "discs", "shear");
    const auto expected = read_curve(other.result("curves.csv"), "discs", "shear");
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_NEAR(found[i].modulus / expected[i].modulus, 1.0, 1e-3) << directory << ", " << found[i].time;
    }
  }

  static std::unique_ptr<StudyDirectory> study;
  static std::string output_of_run;
};

std::unique_ptr<StudyDirectory> RespondWithMaterials::study;
std::string RespondWithMaterials::output_of_run;

TEST_F(RespondWithMaterials, TheRunTellsWhatItHasSampledOfEachPhase) {
  EXPECT_THAT(output_of_run, HasSubstr("(at Laplace variables, matrix from 1 MPa to 891 MPa, interphase from 10 MPa to "
                                       "1 GPa) about"));
}

TEST_F(RespondWithMaterials, AgreesWithRunsOfOtherInterphases) {
  for (const std::string name : {"soft", "stiff"}) {
    const auto answer = respond({"--material", "interphase=" + name + ".toml"});
    ASSERT_EQ(answer.exit_code, 0) << answer.errors;
    EXPECT_THAT(answer.output, HasSubstr("with " + name + " as interphase; error of the reduced responses"));
  }
  expect_run("respond-soft", {"materials.interphase.shear=20 MPa"});
  expect_run("respond-stiff", {"materials.interphase.shear=1 GPa"});
}

TEST_F(RespondWithMaterials, TakesTheMatrixByNameToo) {
  for (const std::string name : {"aged.toml", "matrix=aged.toml", "binder=aged.toml"}) {
    const auto answer = respond({"--material", "interphase=soft.toml", "--material", name, "--overwrite"});
    ASSERT_EQ(answer.exit_code, 0) << answer.errors;
    EXPECT_THAT(answer.output, HasSubstr("with soft as interphase, aged as "));
  }
  expect_run("respond-soft-aged",
             {"materials.interphase.shear=20 MPa",
              R"(materials.binder.shear={ equilibrium = "2 MPa", terms = [{ time = "1 ms", modulus = "400 MPa" }, )"
              R"({ time = "30 ms", modulus = "50 MPa" }] })"});
}

TEST_F(RespondWithMaterials, TheMatrixAloneKeepsTheInterphaseOfTheRun) {
  const auto answer = respond({"--material", "aged.toml"});
  ASSERT_EQ(answer.exit_code, 0) << answer.errors;
  EXPECT_THAT(answer.output, HasSubstr("with aged as matrix; error"));
  EXPECT_EQ(respond({"--material", "aged.toml", "--stage", "discs"}).exit_code, 0);
}

TEST_F(RespondWithMaterials, RefusesAllMistakesAtOnce) {
  const auto refused =
      respond({"--material", "interfase=soft.toml", "--material", "glass=stiff.toml", "--material", "aged.toml",
               "--material", "binder=aged.toml", "--material", "interphase=none.toml", "--out", "refused"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.errors,
              AllOf(HasSubstr("no material or phase \"interfase\" varies, did you mean \"interphase\"?"),
                    HasSubstr("glass does not vary: its phase is elastic"),
                    HasSubstr("tests.quasistatic.vary = { \"glass\" = { shear = [\"3 GPa\", \"300 GPa\"] } }"),
                    HasSubstr("binder is given twice"), HasSubstr("none.toml: no such file")));
  EXPECT_FALSE(std::filesystem::exists(study->path() / "refused"));
  const auto broken = respond({"--material", "interphase=broken.toml", "--material", "filler=soft.toml"});
  EXPECT_EQ(broken.exit_code, 2);
  EXPECT_THAT(broken.errors, AllOf(HasSubstr("broken.toml:1:11: density: expected"), HasSubstr("bulk: missing"),
                                   HasSubstr("the fillers do not vary: they are elastic")));
  const auto both = respond({"--material", "interphase=soft.toml", "--temperature", "40 degC"});
  EXPECT_EQ(both.exit_code, 2);
  EXPECT_THAT(both.errors, HasSubstr("either --material FILE.toml or --temperature"));
}

TEST_F(RespondWithMaterials, RefusesAnInterphaseBeyondWhatWasSampledAndSaysWhatToDo) {
  const auto refused = respond({"--material", "interphase=rigid.toml"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.errors, AllOf(HasSubstr("rigid shows a shear modulus of 9 GPa; the responses hold from "
                                              "9.5 MPa to 1.05 GPa"),
                                    HasSubstr("are sampled with tests.quasistatic.vary")));
}

TEST_F(RespondWithMaterials, AFileWhoseNameHasAnEqualsSignIsTheMatrix) {
  study->write("a=b.toml", aged);
  const auto answer = respond({"--material", "a=b.toml"});
  ASSERT_EQ(answer.exit_code, 0) << answer.errors;
  EXPECT_THAT(answer.output, HasSubstr("with a=b as matrix"));
  const auto empty = respond({"--material", "interphase="});
  EXPECT_EQ(empty.exit_code, 2);
  EXPECT_THAT(empty.errors, HasSubstr("expected FILE.toml or NAME=FILE.toml, got \"interphase=\""));
}

TEST(CheckOfVariedMaterials, TellsWhatIsSampledAndCountsItsTime) {
  const StudyDirectory study(coated_discs);
  EXPECT_THAT(run_breccia(study.path(), {"check", "deck.toml"}).output,
              HasSubstr("over the whole relaxation of the matrix, and over interphase with shear 10 MPa .. 1 GPa"));
}

}  // namespace
}  // namespace breccia::test
