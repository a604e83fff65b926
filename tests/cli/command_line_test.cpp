#include <regex>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "command.hpp"
#include "dynamics/instruction_set.hpp"
#include "good_deck.hpp"
#include "scoped_variable.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class CommandLine : public testing::Test {
 protected:
  void SetUp() override { directory.write("deck.toml", test::good_deck); }
  [[nodiscard]] test::Outcome run(const std::vector<std::string>& arguments) const {
    return test::run_breccia(directory.path(), arguments);
  }

  test::TemporaryDirectory directory;
};

TEST_F(CommandLine, VersionTellsTheBuildAndTheKernels) {
  const auto version = run({"--version"});
  EXPECT_EQ(version.exit_code, 0) << version.errors;
  EXPECT_THAT(version.output, StartsWith("breccia " BRECCIA_VERSION "\nbuild      "));
  EXPECT_THAT(version.output, testing::ContainsRegex("\nbuild      (commit [0-9a-f]+(-dirty)?, )?(GNU|Clang) [0-9.]+, "
                                                     "[A-Za-z]+, [a-z0-9_]+\n"));
  std::vector<std::string_view> supported;
  for (const auto set : supported_instruction_sets()) supported.push_back(name_of(set));
  EXPECT_THAT(version.output, HasSubstr(fmt::format("\nkernels    {} on this processor; in use: {}\n",
                                                    fmt::join(supported, ", "), name_of(chosen_instruction_set()))));
  EXPECT_THAT(version.output, testing::ContainsRegex("\nlibraries  Eigen 3[0-9.]+, .*HDF5 1[0-9.]+, .*PETSc 3[0-9.]+, "
                                                     "MUMPS [0-9.]+, METIS 5[0-9.]+, .*FFTW 3[0-9.]+\n"));
}

TEST_F(CommandLine, VersionTellsTheKernelsThatTheEnvironmentChooses) {
  {
    const test::ScopedVariable baseline("BRECCIA_INSTRUCTION_SET", "baseline");
    EXPECT_THAT(run({"--version"}).output, HasSubstr("; in use: baseline\n"));
  }
  const test::ScopedVariable unknown("BRECCIA_INSTRUCTION_SET", "sse9");
  const auto refused = run({"--version"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.errors, HasSubstr("BRECCIA_INSTRUCTION_SET: expected baseline, avx2 or avx512"));
  EXPECT_EQ(refused.output, "");
}

TEST_F(CommandLine, Help) {
  const auto help = run({"--help"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_THAT(help.output, HasSubstr("check"));
  EXPECT_THAT(run({"check", "--help"}).output, HasSubstr("--set KEY.PATH=VALUE"));
}

TEST_F(CommandLine, CheckShowsTheStudy) {
  const auto check = run({"check", "deck.toml"});
  EXPECT_EQ(check.exit_code, 0);
  EXPECT_EQ(check.errors, "");
  EXPECT_THAT(check.output, StartsWith("Model composite\ndeck.toml"));
  EXPECT_THAT(check.output, HasSubstr("grid     60 x 60 cells of 100 um, 14400 material points"));
}

TEST_F(CommandLine, OverridesMayStandAnywhere) {
  const auto check = run({"check", "--set", "stages.A.cells=30", "deck.toml", "--set=title=B"});
  EXPECT_EQ(check.exit_code, 0) << check.errors;
  EXPECT_THAT(check.output, StartsWith("B\n"));
  EXPECT_THAT(check.output, HasSubstr("30 x 30 cells"));
}

TEST_F(CommandLine, HelpShowsHowACommandIsUsed) {
  for (const auto* command : {"run", "examples", "help"}) {
    const auto help = run({"help", command});
    EXPECT_EQ(help.exit_code, 0) << help.errors;
    EXPECT_THAT(help.output, HasSubstr(std::string("Usage: breccia ") + command));
    EXPECT_EQ(help.output, run({command, "--help"}).output);
  }
  EXPECT_EQ(run({"help"}).output, run({"--help"}).output);
  EXPECT_THAT(run({"help", "run"}).output, HasSubstr("docs/decks.md (breccia examples tells where)"));
}

/// The sum at the end of a check.
struct Sum {
  double seconds = 0.0;
  double megabytes = 0.0;
};

Sum sum_of(const test::Outcome& check) {
  const std::regex words("\ntogether about ([0-9.]+) (m?)s on one core, at most ([0-9.]+) MB of memory\n");
  std::smatch found;
  EXPECT_TRUE(std::regex_search(check.output, found, words)) << check.output;
  if (found.empty()) return {};
  return {std::stod(found[1].str()) * (found[2].length() == 0 ? 1.0 : 1e-3), std::stod(found[3].str())};
}

TEST_F(CommandLine, CheckSumsUp) {
  const auto one = sum_of(run({"check", "deck.toml", "--set", "tests.boundaries=[\"displacement\"]"}));
  const auto two = sum_of(run({"check", "deck.toml", "--set", R"(tests.boundaries=["displacement", "traction"])"}));
  // Two equal tests run one after the other: they take the time of both and the memory of one. Times have two digits.
  EXPECT_NEAR(two.seconds, 2.0 * one.seconds, 0.1 * one.seconds);
  EXPECT_EQ(two.megabytes, one.megabytes);
  EXPECT_GT(one.megabytes, 0.0);
}

TEST_F(CommandLine, CheckPrintsLargeMemoriesInGigabytes) {
  const auto check = run({"check", "deck.toml", "--set", "stages.A.cells=2500"});
  EXPECT_THAT(check.output, HasSubstr(" GB, some "));
  EXPECT_THAT(check.output, testing::Not(HasSubstr("000 MB")));
}

TEST_F(CommandLine, CheckTellsTheCellsForAnError) {
  ASSERT_EQ(run({"new", "starter.toml"}).exit_code, 0);
  // There is no rule for a binder that falls to nothing, as that of the starter deck does without its equilibrium.
  EXPECT_THAT(
      run({"check", "starter.toml", "--set", R"(materials.binder.shear.equilibrium="0 Pa")"}).output,
      HasSubstr(
          "no rule gives the error of the grid, nor cells for an error: a binder that falls faster than 1/t^2\n"));
  // The discs keep 101.2 um apart in a box of 20 mm: in series errors of ten and five per cent need one and a half
  // cells, the least number for which the error is known; with flow 12.8 of 128 cells across a disc of 2 mm serve.
  const auto check = run({"check", "starter.toml", "--error", "10 %", "5 %", "--set", "stages.composite.cells=100",
                          "--set", "tests.mixing=series"});
  EXPECT_THAT(
      check.output,
      HasSubstr("0.51 cells in the narrowest gap, the error of the grid may be of any size; cells = 297 for 10 %, "
                "297 for 5 %\n"));
  EXPECT_THAT(run({"check", "starter.toml"}).output,
              HasSubstr("error of the grid is up to about 3.9 % by a rule; cells = 100 for 5 %, 250 for 2 %, 500 for "
                        "1 %\n"));
  const auto wrong = run({"check", "starter.toml", "--error", "2"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.errors,
              HasSubstr("--error: expected a percentage between 0 and 100 %, such as \"2 %\", got \"2\""));
}

TEST_F(CommandLine, CheckTellsWhatEachOfSeveralProcessesTakes) {
  const auto whole = run({"check", "deck.toml", "--set", "stages.A.cells=2500"});
  const auto shared = run({"check", "deck.toml", "--set", "stages.A.cells=2500", "--processes", "16"});
  EXPECT_EQ(shared.exit_code, 0) << shared.errors;
  EXPECT_THAT(shared.output, StartsWith(whole.output));
  EXPECT_THAT(shared.output,
              testing::ContainsRegex("\non 16 processes with a core each at best 1/16 of the time, [0-9.]+ [a-z]+, and "
                                     "[0-9.]+ MB of memory a process\n$"));
  const auto wrong = run({"check", "deck.toml", "--processes", "0"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.errors, HasSubstr("--processes"));
}

struct Mistyped {
  std::vector<std::string> arguments;
  int exit_code;
  const char* message;
};

TEST_F(CommandLine, MistypedCommands) {
  directory.write("syntax.toml", "[materials\n");
  directory.write("binary.toml", std::string_view("\x80\x00\xff", 3));
  const std::vector<Mistyped> cases{
      {{}, 2, "a command is required"},
      {{"chek", "deck.toml"}, 2, R"(unknown command "chek", did you mean "check"?)"},
      {{"deck.toml"}, 2, "unknown command \"deck.toml\""},
      {{"completion"}, 2, "SHELL is required"},
      {{"completion", "fish"}, 2, "SHELL: fish not in {bash,zsh}"},
      {{"help", "chek"}, 2, R"(unknown command "chek", did you mean "check"?)"},
      {{"--verison"}, 2, R"(unknown option "--verison", did you mean "--version"?)"},
      {{"-v"}, 2, R"(unknown option "-v", did you mean "--version"?)"},
      {{"-q", "check", "deck.toml"}, 2, R"(unknown option "-q"; known: "--help", "--version")"},
      {{"--set", "title=a", "check", "deck.toml"},
       2,
       R"(option "--set" stands before the command: expected breccia check --set)"},
      {{"check"}, 2, "DECK is required\n\"breccia check --help\" shows how it is used\n"},
      {{"check", "deck.toml", "more.toml", "b.toml"},
       2,
       "unexpected argument \"more.toml\": breccia check takes one DECK\nunexpected argument \"b.toml\": breccia "
       "check"},
      {{"bench", "deck.toml"}, 2, R"(unexpected argument "deck.toml": breccia bench takes options alone)"},
      {{"check", "deck.toml", "--sett", "a=b"}, 2, R"(unknown option "--sett", did you mean "--set"?)"},
      {{"run", "deck.toml", "--thread", "1"}, 2, R"(unknown option "--thread", did you mean "--threads"?)"},
      {{"run", "--thread", "1", "deck.toml"}, 2, R"(unknown option "--thread", did you mean "--threads"?)"},
      {{"run", "-t", "1", "deck.toml"}, 2, R"(unknown option "-t", did you mean "--threads" or "--time-limit"?)"},
      {{"run", "--threads=0", "--queit"}, 2, "unknown option \"--queit\", did you mean \"--quiet\"?\n--threads: "},
      {{"fit", "--ref=20", "--tou", "creep", "a.csv"},
       2,
       "unknown option \"--ref\", did you mean \"--reference-temperature\"?\nunknown option \"--tou\", did you mean "
       "\"--to\"?"},
      {{"run", "deck.toml", "--time-limit", "-1 h"}, 2, R"(--time-limit: expected a positive time, got "-1 h")"},
      {{"run", "deck.toml", "--checkpoint-interval", "-1 min"},
       2,
       R"(--checkpoint-interval: expected a positive time, got "-1 min")"},
      {{"check", "deck.toml", "--set"}, 2, "--set"},
      {{"check", "none.toml"}, 2, "none.toml: no such deck"},
      {{"check", "."}, 2, "expected a deck, got a directory"},
      {{"check", "syntax.toml"}, 2, "syntax.toml:1:11: not TOML"},
      {{"check", "binary.toml"}, 2, "binary.toml: expected text, got a binary file"},
      {{"check", "deck.toml", "--set", "title"}, 2, "--set title: expected key.path=value"},
      {{"check", "deck.toml", "--set", "stages.B.cells=3"}, 2, R"(stages has no entry "B", did you mean "A"?)"},
      {{"check", "deck.toml", "--set", "stage.A.cells=3"}, 2, R"(unknown key "stage", did you mean "stages"?)"},
      {{"check", "deck.toml", "--set", "materials.binder.bulk=3.6 um"}, 2, "--set materials.binder.bulk=3.6 um: "},
  };
  for (const auto& mistyped : cases) {
    const auto outcome = run(mistyped.arguments);
    EXPECT_EQ(outcome.exit_code, mistyped.exit_code) << mistyped.message;
    EXPECT_THAT(outcome.errors, HasSubstr(mistyped.message));
    EXPECT_EQ(outcome.output, "") << mistyped.message;
  }
}

}  // namespace
}  // namespace breccia
