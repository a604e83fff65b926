#include <cmath>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "good_deck.hpp"
#include "io/text_file.hpp"
#include "messages.hpp"
#include "model_deck.hpp"
#include "study_directory.hpp"

namespace breccia {
namespace {

using test::StudyDirectory;
using testing::AllOf;
using testing::Contains;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using Json = nlohmann::json;

/// A study whose runs are interrupted at the first possible moment, again and again, until it is complete.
class Resume : public testing::Test {
 protected:
  /// A time limit that grows with the number of interruptions, so that slow builds end, too.
  static std::string time_limit(int interruptions) {
    return std::to_string(50.0 * std::pow(1.1, interruptions)) + " ms";
  }

  /// Returns how often it was interrupted.
  int run_bit_by_bit() {
    for (int interruptions = 0;; ++interruptions) {
      const auto outcome = study_.breccia("run", {"--resume", "--time-limit", time_limit(interruptions)});
      if (outcome.exit_code == 0) return interruptions;
      EXPECT_EQ(outcome.exit_code, 130) << outcome.errors;
      EXPECT_EQ(outcome.errors, "interrupted; the state is saved, and --resume continues from it\n");
      if (outcome.exit_code != 130) return -1;
    }
  }
  void interrupt() const { EXPECT_EQ(study_.breccia("run", {"--time-limit", "1 us"}).exit_code, 130); }

  StudyDirectory study_{test::model_deck};
};

TEST_F(Resume, EndsWithTheBytesOfARunInOneGo) {
  const auto averaged = test::replaced(std::string(test::model_deck), "\"standard\"", "\"averaged\"");
  const auto mixed = test::replaced(averaged, "method     = \"dynamic\"", R"(method = ["quasistatic", "dynamic"])");
  for (const auto& deck : {std::string(test::model_deck), mixed}) {
    study_.write("deck.toml", deck);
    const StudyDirectory whole(deck);
    ASSERT_EQ(whole.breccia("run").exit_code, 0);
    EXPECT_GT(run_bit_by_bit(), 0);
    EXPECT_EQ(study_.results(), whole.results());
    for (const auto* file : {"curves.csv", "prony.csv", "A/fields.vtkhdf", "A/modulus.svg"}) {
      EXPECT_EQ(read_text(study_.result(file)), read_text(whole.result(file))) << file;
    }
    std::filesystem::remove_all(study_.path() / "out");
  }
}

TEST_F(Resume, WithoutEarlierResultsARunStartsAnew) {
  const auto outcome = study_.breccia("run", {"--resume", "--set", "tests.method=quasistatic"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
}

double wall_time_of_packing(const StudyDirectory& study) {
  const auto json = Json::parse(read_text(study.result("study.json")));
  return json["stages"][0]["microstructure"]["wall_time_s"];
}

TEST_F(Resume, PackingDoesNotChangeTheResultsOfARun) {
  // Runs until the second of two tests has saved its state.
  int interruptions = 0;
  while (study_.breccia("run", {"--resume", "--time-limit", time_limit(interruptions++)}).exit_code == 130 &&
         Json::parse(read_text(study_.result("study.json")))["stages"][0]["tests"].empty()) {
  }
  const auto before = read_text(study_.result("study.json"));
  EXPECT_EQ(study_.breccia("pack", {"--resume"}).exit_code, 0);
  EXPECT_EQ(read_text(study_.result("study.json")), before);
}

TEST_F(Resume, PackingsGoOnToTheSameDiscsAndRunsFromThere) {
  // There are so many particles that a packing takes several steps.
  const std::string deck = test::replaced(std::string(test::good_deck), "\"1 mm\"", "\"0.1 mm\"");
  const std::vector<std::string> options = {"--set", "stages.A.filler.gap=1 um", "--set", "tests.method=quasistatic"};
  const auto and_resume = [&] {
    auto all = options;
    all.insert(all.end(), {"--resume", "--time-limit", "1 us"});
    return all;
  }();
  const StudyDirectory whole(deck), parts(deck);
  ASSERT_EQ(whole.breccia("pack", options).exit_code, 0);
  int interruptions = 0;
  for (; parts.breccia("pack", and_resume).exit_code == 130; ++interruptions) ASSERT_LT(interruptions, 1000);
  EXPECT_GT(interruptions, 3);
  EXPECT_EQ(read_text(parts.result("A/microstructure.csv")), read_text(whole.result("A/microstructure.csv")));
  auto and_go_on = options;
  and_go_on.emplace_back("--resume");
  const auto packing_time = wall_time_of_packing(parts);
  const auto run = parts.breccia("run", and_go_on);
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_EQ(wall_time_of_packing(parts), packing_time) << "packed once more";
  const auto complete = parts.results();
  const auto pack = parts.breccia("pack", and_go_on);
  EXPECT_THAT(pack.output, HasSubstr("The results in out are complete"));
  EXPECT_EQ(parts.results(), complete);
}

TEST_F(Resume, AnotherDeckIsRefusedWithTheLine) {
  interrupt();
  const auto before = study_.results();
  study_.write("deck.toml", test::replaced(std::string(test::model_deck), "1.5 g/cm^3", "1.6 g/cm^3"));
  const auto refused = study_.breccia("run", {"--resume"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.errors,
              AllOf(HasSubstr("out: cannot resume from these results: deck.toml: line 9 was"), HasSubstr("1.5 g/cm^3"),
                    HasSubstr("1.6 g/cm^3"), HasSubstr("--out"), HasSubstr("--overwrite")));
  EXPECT_EQ(study_.results(), before) << "nothing is lost";
}

// A comment changes no result.
TEST_F(Resume, AnotherDataFileIsRefusedWithItsName) {
  const auto terms = [](const char* modulus) {
    return std::string("relaxation_time_s,modulus_Pa\n0.01,") + modulus + "\n";
  };
  study_.write("p.csv", terms("5e5"));
  const auto deck =
      test::replaced(std::string(test::model_deck), R"({ terms = [{ time = "10 ms", modulus = "0.5 MPa" }] })",
                     R"({ prony = "p.csv" })");
  study_.write("deck.toml", deck);
  interrupt();
  study_.write("p.csv", terms("6e5"));
  study_.write("deck.toml", "# a comment\n" + deck);
  const auto refused = study_.breccia("run", {"--resume"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.errors, HasSubstr("out: cannot resume from these results: the data file p.csv differs; "));
}

TEST_F(Resume, OtherOverridesAreRefused) {
  interrupt();
  const auto refused = study_.breccia("run", {"--resume", "--set", "stages.A.cells=12"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.errors, HasSubstr(R"(the overrides were [], are ["stages.A.cells=12"])"));
}

TEST_F(Resume, AnotherVersionIsRefused) {
  interrupt();
  write_text(study_.result("study.json"),
             test::replaced(read_text(study_.result("study.json")), R"("version": ")", R"("version": "9)"));
  const auto refused = study_.breccia("run", {"--resume"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.errors, HasSubstr("of version 9"));
}

TEST_F(Resume, ATornCheckpointIsNamed) {
  interrupt();
  const auto checkpoint = study_.result("A/shear-displacement-dynamic-24.checkpoint.h5");
  const auto bytes = read_text(checkpoint);
  write_text(checkpoint, bytes.substr(0, bytes.size() / 2));
  const auto outcome = study_.breccia("run", {"--resume"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.errors, HasSubstr("out/A/shear-displacement-dynamic-24.checkpoint.h5: torn, or no checkpoint of "
                                        "Breccia; this packing or test starts anew"));
  EXPECT_THAT(study_.results(), Not(Contains(EndsWith("checkpoint.h5"))));
}

TEST_F(Resume, WithoutTheOptionEverythingBeginsAnew) {
  interrupt();
  const auto outcome = study_.breccia("run", {"--set", "stages.A.cells=12"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(study_.results(), Not(Contains(EndsWith("checkpoint.h5"))));
}

TEST_F(Resume, HalfWrittenFilesOfAKilledRunAreRemoved) {
  interrupt();
  write_text(study_.result("curves.csv.123.partial"), "half");
  write_text(study_.result("A/modulus.svg.123.partial"), "half");
  ASSERT_EQ(study_.breccia("run", {"--resume"}).exit_code, 0);
  EXPECT_THAT(study_.results(), Not(Contains(EndsWith(".partial"))));
  // This also holds for a run that was killed when only its page was still to be written.
  write_text(study_.result("report.html.124.partial"), "half");
  ASSERT_EQ(study_.breccia("run", {"--resume"}).exit_code, 0);
  EXPECT_THAT(study_.results(), Not(Contains(EndsWith(".partial"))));
}

TEST_F(Resume, InvalidTimesAreRefused) {
  for (const auto* option : {"--time-limit", "--checkpoint-interval"}) {
    const auto outcome = study_.breccia("run", {option, "2 m"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.errors, std::string(option) + ": expected a time, got \"2 m\"\n");
  }
}

}  // namespace
}  // namespace breccia
