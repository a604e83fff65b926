#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "command.hpp"
#include "good_deck.hpp"
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

TEST_F(CommandLine, VersionAndHelp) {
  const auto version = run({"--version"});
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_THAT(version.output, testing::MatchesRegex("breccia [0-9]+\\.[0-9]+\\.[0-9]+\n"));
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
      {{"--verison"}, 2, "--verison"},
      {{"check"}, 2, "DECK is required"},
      {{"check", "deck.toml", "more.toml"}, 2, "more.toml"},
      {{"check", "deck.toml", "--sett", "a=b"}, 2, "--sett"},
      {{"check", "deck.toml", "--set"}, 2, "--set"},
      {{"check", "none.toml"}, 2, "none.toml: no such deck"},
      {{"check", "."}, 2, "expected a deck, got a directory"},
      {{"check", "syntax.toml"}, 2, "syntax.toml:1:11: not TOML"},
      {{"check", "binary.toml"}, 2, "binary.toml:1:1: not TOML"},
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
