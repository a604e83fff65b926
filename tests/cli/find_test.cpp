// Tests of `breccia find`.

#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "coated_discs.hpp"
#include "io/text_file.hpp"
#include "messages.hpp"
#include "study_directory.hpp"
#include "tables/csv.hpp"

namespace breccia::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// The coated discs with an interphase that is sought.
std::string discs_with(const std::string& interphase) {
  const auto deck = replaced(std::string(coated_discs), "shear   = \"100 MPa\"", "shear   = " + interphase);
  return replaced(deck, "[tests.quasistatic]\nvary = { interphase = { shear = [\"10 MPa\", \"1 GPa\"] } }\n",
                  "mixing = \"series\"\n");
}

std::string sought_discs() {
  return discs_with(R"({ from = "20 MPa", to = "500 MPa", scale = "logarithmic" })");
}

Outcome run_find(const StudyDirectory& study, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "find");
  arguments.insert(arguments.end(), {"--out", "out", "--threads", "2"});
  return run_breccia(study.path(), arguments);
}

double at_ten_ms(const std::filesystem::path& directory) {
  return modulus_at(read_curve(directory / "curves.csv", "discs", "shear"), 0.01);
}

TEST(Find, FindsAModulusOfWhichTheTruthIsKnown) {
  const StudyDirectory study(discs_with("\"130 MPa\""));
  ASSERT_EQ(study.breccia("run").exit_code, 0);
  const double truth = at_ten_ms(study.result(""));
  study.write("sought.toml", sought_discs());
  const auto run = run_find(study, {"interphase.shear", "sought.toml", "--so-that",
                                    fmt::format("G(10 ms) = {} Pa", truth), "--model-error", "1 %", "--overwrite"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.output, AllOf(HasSubstr("materials.interphase.shear"), HasSubstr("The study with"),
                                HasSubstr("found.csv, find.csv, find.svg")));
  EXPECT_NEAR(at_ten_ms(study.result("find/study")) / truth, 1.0, 1e-3);
  const auto points = read_csv(study.result("find/find.csv"), {});
  const auto found = read_csv(study.result("find/found.csv"), {"input"});
  EXPECT_NEAR(found.numbers("value").front() / 130e6, 1.0, 0.02);
  EXPECT_NEAR(found.numbers("reached").front() / truth, 1.0, 1e-3);
  EXPECT_LT(found.numbers("lower_95").front(), 130e6);
  EXPECT_GT(found.numbers("upper_95").front(), 130e6);
  EXPECT_NEAR(points.numbers("input").front() / 20e6, 1.0, 0.01);
  EXPECT_NEAR(points.numbers("input").back() / 500e6, 1.0, 0.01);
  EXPECT_LT(points.numbers("lower_95").front(), points.numbers("value").front());
  EXPECT_THAT(read_text(study.result("find/find.svg")), HasSubstr("materials.interphase.shear / MPa"));
  // Another condition takes the study that is there.
  const auto again =
      run_find(study, {"shear", "sought.toml", "--so-that", fmt::format("G(10 ms) = {} Pa", 0.95 * truth)});
  ASSERT_EQ(again.exit_code, 0) << again.errors;
  EXPECT_NEAR(at_ten_ms(study.result("find/study")) / truth, 0.95, 1e-3);
}

TEST(Find, FindsAGeometryByBoxes) {
  const auto deck = replaced(discs_with("\"100 MPa\""), R"("0.4 mm")", R"({ from = "0.2 mm", to = "0.5 mm" })");
  const StudyDirectory study(deck);
  const auto run = run_find(study, {"thickness", "deck.toml", "--boxes", "8", "--so-that", "G(10 ms) = 115 MPa"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.output,
              AllOf(HasSubstr("(a box for each value)"), HasSubstr("stages.discs.filler.coating.thickness")));
  EXPECT_NEAR(at_ten_ms(study.result("find/study")) / 115e6, 1.0, 0.05);
  EXPECT_TRUE(std::filesystem::exists(study.result("box-08/study.json")));
}

TEST(Find, FindsALossTangent) {
  const auto deck = replaced(sought_discs(), R"(times      = ["1 ms", "1 s"])", R"(frequencies = ["1 Hz", "100 Hz"])");
  const StudyDirectory study(deck);
  const auto run = run_find(study, {"shear", "deck.toml", "--so-that", "tan_delta(10 Hz) = 0.7"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.output, AllOf(HasSubstr("(95 % without the error of the model: "),
                                HasSubstr("tan_delta(10 Hz): 0.7, as wanted")));
  EXPECT_THAT(run.output + run.errors, HasSubstr("the error of the model in a phase is not known"));
  const auto refused =
      run_find(study, {"shear", "deck.toml", "--so-that", "tan_delta(10 Hz) = 0.7", "--model-error", "5 %"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.errors, HasSubstr("nothing is known of that of a phase"));
}

TEST(Find, SaysWhatCanBeHadWhereNoValueServes) {
  const StudyDirectory study(sought_discs());
  const auto run = run_find(study, {"shear", "deck.toml", "--so-that", "G(10 ms) = 30 GPa"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.errors, AllOf(HasSubstr("no materials.interphase.shear from 20 MPa to 500 MPa makes G(10 ms) 30 GPa"),
                                HasSubstr("at most, with 500 MPa")));
  EXPECT_FALSE(std::filesystem::exists(study.result("find")));
}

TEST(Find, RefusesMistakesBeforeAnythingIsSolved) {
  const StudyDirectory study(sought_discs());
  const auto refusal = [&](const std::vector<std::string>& arguments) {
    const auto run = run_find(study, arguments);
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_FALSE(std::filesystem::exists(study.result("")));
    return run.errors;
  };
  const std::string wish = "G(10 ms) = 50 MPa";
  EXPECT_THAT(refusal({"fraction", "deck.toml", "--so-that", wish}),
              HasSubstr("\"fraction\" is not one of the uncertain inputs of the deck (materials.interphase.shear)"));
  EXPECT_THAT(
      refusal({"fraction", "deck.toml", "--so-that", "H(1 s) = 1 MPa", "--stage", "disks", "--model-error", "5"}),
      AllOf(HasSubstr("\"fraction\" is not"), HasSubstr("unknown quantity \"H\""), HasSubstr("no stage"),
            HasSubstr("--model-error")))
      << "all at once";
  EXPECT_THAT(refusal({"shear", "deck.toml", "--so-that", "G'(1 Hz) = 1 MPa"}),
              HasSubstr("expected a relaxation modulus in shear or bulk at a time"));
  EXPECT_THAT(refusal({"shear", "deck.toml", "--so-that", "E(10 ms) = 1 MPa"}), HasSubstr("young modulus"));
  EXPECT_THAT(refusal({"shear", "deck.toml", "--so-that", "K(10 ms) = 1 GPa"}), HasSubstr("no test in bulk"));
  EXPECT_THAT(refusal({"shear", "deck.toml", "--so-that", "G(1 h) = 1 MPa"}),
              HasSubstr("G(1 h): outside of the curves of the study, 1 ms to 1 s"));
  EXPECT_THAT(refusal({"shear", "deck.toml", "--so-that", wish, "--model-error", "5"}),
              HasSubstr("--model-error: expected a percentage"));
  EXPECT_THAT(refusal({"shear", "deck.toml", "--so-that", wish, "--stage", "disks"}),
              HasSubstr("did you mean \"discs\"?"));
  EXPECT_THAT(refusal({"shear", "deck.toml", "--so-that", wish, "--set", "materials.interphase.shear=100 MPa"}),
              HasSubstr("every input is certain"));
  EXPECT_THAT(refusal({"thickness", "deck.toml", "--so-that", wish, "--boxes", "3", "--set",
                       R"(stages.discs.filler.coating.thickness={ from = "0.2 mm", to = "0.5 mm" })"}),
              HasSubstr("boxes: expected 4 or more to follow stages.discs.filler.coating.thickness, got 3"));
  EXPECT_THAT(refusal({"shear", "deck.toml"}), HasSubstr("--so-that"));
  EXPECT_THAT(refusal({"deck.toml", "--so-that", wish}), HasSubstr("DECK"));
  EXPECT_THAT(refusal({"shear", "none.toml", "--so-that", wish}), HasSubstr("none.toml"));
  EXPECT_THAT(refusal({"shear", "deck.toml", "--so-that", wish, "--set",
                       "stages.discs.filler.material={ any = [\"glass\", \"interphase\"] }"}),
              HasSubstr("any of several values; expected"));
}

}  // namespace
}  // namespace breccia::test
