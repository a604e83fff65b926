#include "studio/command_line.hpp"

#include <gtest/gtest.h>

namespace breccia::studio {
namespace {

TEST(Shown, IsTheLineThatAShellTakes) {
  EXPECT_EQ(shown({.arguments = {"check", "a.toml"}}), "breccia check a.toml");
  EXPECT_EQ(shown({.arguments = {"fit", "my data.csv", "--columns", "storage=E' [MPa]"}}),
            R"(breccia fit 'my data.csv' --columns 'storage=E'\'' [MPa]')");
  EXPECT_EQ(shown({.arguments = {"run", ""}}), "breccia run ''");
  EXPECT_EQ(shown({.arguments = {"run", "$(reboot);`x`.toml"}}), "breccia run '$(reboot);`x`.toml'");
}

TEST(Shown, LeavesOutWhatNoUserNeeds) {
  EXPECT_EQ(shown({.arguments = {"pack", "a.toml"}, .hidden = {"--out", "/somewhere"}}), "breccia pack a.toml");
}

TEST(MistakesIn, TakesTheLinesOfTheDeckAlone) {
  const auto mistakes = mistakes_in(
      "a.toml:12:3: stages.0.box: expected a length: \"48 um\"\n"
      "a.toml: the deck is empty\n"
      "b.csv:3: b: expected a number\n"
      "warning: a.toml:1:1: no\n"
      "a.toml:7: tests: missing\n",
      "a.toml");
  ASSERT_EQ(mistakes.size(), 3U);
  EXPECT_EQ(mistakes[0].line, 12);
  EXPECT_EQ(mistakes[0].column, 3);
  EXPECT_EQ(mistakes[0].message, "stages.0.box: expected a length: \"48 um\"");
  EXPECT_EQ(mistakes[1].line, 0);
  EXPECT_EQ(mistakes[1].message, "the deck is empty");
  EXPECT_EQ(mistakes[2].line, 7);
  EXPECT_EQ(mistakes[2].column, 0);
  EXPECT_EQ(mistakes[2].message, "tests: missing");
}

TEST(FailureIn, IsWhatFollowsThePlan) {
  EXPECT_EQ(failure_in("title\n\nplan, with an estimate\n  A: 3 cells\ntogether about 3 d\nA: too large\nB: too\n"),
            "A: too large\nB: too");
  EXPECT_EQ(failure_in("plan, with an estimate\nmaterial a: expected more\n"), "material a: expected more");
  EXPECT_EQ(failure_in("file.csv: 3 rows\n  time\n\n--reference-temperature: no sweep\n"),
            "--reference-temperature: no sweep");
  EXPECT_EQ(failure_in(""), "");
  EXPECT_EQ(failure_in("x\n\n"), "");
}

}  // namespace
}  // namespace breccia::studio
