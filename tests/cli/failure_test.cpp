#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "good_deck.hpp"
#include "messages.hpp"
#include "model_deck.hpp"
#include "scoped_path.hpp"
#include "study_directory.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using test::model_deck;
using test::StudyDirectory;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

namespace fs = std::filesystem;

const std::string good_deck(test::good_deck);

TEST(RunFailure, OutputDirectoryUnderAFile) {
  const StudyDirectory study(model_deck);
  study.write("out", "not a directory");
  for (const auto* command : {"run", "pack"}) {
    const auto outcome = test::run_breccia(study.path(), {command, "deck.toml", "--out", "out/put"});
    EXPECT_EQ(outcome.exit_code, 4) << command;
    EXPECT_THAT(outcome.errors, HasSubstr("out/put: cannot make this directory: Not a directory")) << command;
    EXPECT_EQ(outcome.output, "") << command;
  }
}

TEST(RunFailure, TooLittleMemory) {
  const StudyDirectory study(good_deck);
  for (const auto& sweep : {std::vector<std::string>{}, {"--seeds", "2"}}) {
    auto options = sweep;
    options.insert(options.end(), {"--set", "stages.A.cells=1000000"});
    const auto run = study.breccia("run", options);
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_THAT(run.errors, AllOf(HasSubstr("A: 1000000 x 1000000 cells take about"), HasSubstr("would fit"),
                                  testing::EndsWith(" (--no-memory-check runs them nevertheless)\n")));
    EXPECT_FALSE(fs::exists(study.path() / "out"));
  }
}

TEST(RunFailure, ADirectoryStandsWhereAFileBelongs) {
  const StudyDirectory study(model_deck);
  fs::create_directories(study.result("curves.csv/in-the-way"));
  const auto run = study.breccia("run", {"--set", "stages.A.cells=8"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.errors,
              HasSubstr("out/curves.csv: the results would replace this file, which Breccia did not write"));
  EXPECT_THAT(study.results(), Not(Contains(HasSubstr("partial"))));
}

TEST(RunFailure, NoRoomForStandardOutput) {
  const StudyDirectory study(model_deck);
  fs::create_symlink("/dev/full", study.path() / "stdout");
  test::RunningCommand check(study.path(), StudyDirectory::arguments("check"));
  EXPECT_FALSE(check.reaches([] { return false; }));
  fs::remove(study.path() / "stdout");  // reading the file would not end
  study.write("stdout", "");
  const auto outcome = check.wait();
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_EQ(outcome.errors, "standard output: cannot write\n");
}

/// Tests without any program on the PATH, such as ssh, with which Open MPI would start other processes.
class OnABareMachine : public testing::Test {
 protected:
  const test::ScopedPath path{"/nonexistent"};
};

TEST_F(OnABareMachine, ARunIsWhole) {
  const StudyDirectory study(model_deck);
  const auto run = study.breccia("run", {"--set", "stages.A.cells=8", "--set", "tests.method=quasistatic"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.errors, "");
  for (const auto* file : {"curves.csv", "report.html", "A/microstructure.svg", "A/modulus.svg", "A/response.h5"}) {
    EXPECT_TRUE(fs::exists(study.result(file))) << file;
  }
}

TEST(RunFailure, ParticlesJam) {
  const StudyDirectory study(test::replaced(good_deck, "fraction = 0.5", "fraction = 0.85"));
  const auto pack = study.breccia("pack", {"--set", "stages.A.filler.gap=0 m"});
  EXPECT_EQ(pack.exit_code, 3);
  EXPECT_THAT(
      pack.errors,
      testing::ContainsRegex(
          "A: [0-9]+ particles of 1 mm at a fraction of 0.85 with no gap between them jam: they would fill [0-9.]+ % "
          "of the room between the walls, and are stuck at [0-9.]+ %; a fraction of 0.[67][0-9]* or less"));
  EXPECT_THAT(study.results(), IsEmpty());
}

TEST(RunFailure, ParticlesCannotKeepTheirGap) {
  const StudyDirectory study(test::replaced(good_deck, "fraction = 0.5", "fraction = 0.85"));
  const auto pack = study.breccia("pack");
  EXPECT_EQ(pack.exit_code, 3);
  EXPECT_THAT(pack.errors,
              AllOf(testing::StartsWith("A: "), HasSubstr("with a gap of 100 um (1 cell of 100 um) cannot be packed")));
}

TEST(RunFailure, ExplicitDiscsOverlap) {
  auto deck = test::replaced(std::string(model_deck), R"(, sizes = { diameter = "2 mm" })", "");
  deck = test::replaced(deck, R"("regular", columns = 2, rows = 2)", R"("explicit", discs = "discs.csv")");
  const StudyDirectory study(deck);
  study.write("discs.csv", "x_m,y_m,diameter_m\n2e-3,2e-3,2e-3\n3e-3,2e-3,2e-3\n");
  for (const auto* command : {"check", "pack", "run"}) {
    const auto outcome = study.breccia(command);
    EXPECT_EQ(outcome.exit_code, 2) << command;
    EXPECT_THAT(outcome.errors, HasSubstr("deck.toml:19:42: stages.A.packing.discs: discs.csv: ")) << command;
    EXPECT_THAT(outcome.errors, AllOf(HasSubstr("disc 1 "), HasSubstr("overlap by 0.001 m"))) << command;
  }
  study.write("discs.csv", "x_m,y_m,diameter_m\n0.5e-3,2e-3,2e-3\n");
  EXPECT_THAT(study.breccia("check").errors, HasSubstr("crosses a wall by 0.0005 m"));
}

/// Times and mass scaling factors for a box of the matrix, and the reason why they are incompatible.
struct BadFactors {
  const char* times;
  const char* factors;
  const char* message;
};

TEST(RunFailure, MassScalingFactorsDoNotCoverTheTimes) {
  const StudyDirectory study(test::homogeneous_deck);
  const std::vector<BadFactors> cases{
      {R"(["1 ms", "50 ms"])", "[1e6]",
       "factor 1e+06 the run is valid nowhere up to 5.000e-02 s, which is less than 3 there-and-back"},
      {R"(["15 ms", "50 ms"])", "[15]", "relaxes faster than waves cross the box; give a smaller mass scaling factor"},
      {R"(["1 ms", "15 ms"])", "[5]", "but times begin at 1.000e-03 s; give a first mass scaling factor below 0.25"},
  };
  for (const auto& [times, factors, message] : cases) {
    const auto run = study.breccia("run", {"--set", fmt::format("tests.times={}", times), "--set",
                                           fmt::format("tests.dynamic.mass_scaling_factors={}", factors)});
    EXPECT_EQ(run.exit_code, 3) << factors;
    EXPECT_THAT(run.errors,
                AllOf(testing::StartsWith("A shear, displacement, 24 cells, dynamic: "), HasSubstr(message)))
        << factors;
    EXPECT_THAT(study.results(), Not(Contains("curves.csv"))) << factors;
  }
}

TEST(RunFailure, AnEmptyWindowOfTimes) {
  const StudyDirectory study(model_deck);
  const auto run = study.breccia("run", {"--set", R"(tests.times=["1 ms", "1 ms"])"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.errors, HasSubstr("tests.times: expected two rising times"));
  EXPECT_THAT(study.results(), IsEmpty());
}

}  // namespace
}  // namespace breccia
