#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "command.hpp"
#include "io/text_file.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(New, WritesADeckWithoutAMistake) {
  const test::TemporaryDirectory directory;
  const auto written = test::run_breccia(directory.path(), {"new", "mine.toml"});
  EXPECT_EQ(written.exit_code, 0) << written.errors;
  EXPECT_THAT(written.output, HasSubstr("breccia check mine.toml\n"));
  EXPECT_EQ(read_text(directory.path() / "mine.toml"),
            read_text(std::filesystem::path(BRECCIA_EXAMPLES_DIRECTORY) / "starter.toml"));
  const auto check = test::run_breccia(directory.path(), {"check", "mine.toml"});
  EXPECT_EQ(check.exit_code, 0) << check.errors;
  EXPECT_EQ(check.errors, "");
  EXPECT_THAT(check.output, Not(HasSubstr("warning")));
}

TEST(New, OverwritesNothing) {
  const test::TemporaryDirectory directory;
  directory.write("mine.toml", "# a month of work\n");
  std::filesystem::create_symlink("nowhere", directory.path() / "link.toml");
  for (const auto* name : {"mine.toml", "link.toml"}) {
    const auto refused = test::run_breccia(directory.path(), {"new", name});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.errors, HasSubstr("the file exists and is not overwritten"));
  }
  EXPECT_EQ(read_text(directory.path() / "mine.toml"), "# a month of work\n");
}

TEST(New, RefusesInvalidNames) {
  const test::TemporaryDirectory directory;
  const auto nameless = test::run_breccia(directory.path(), {"new"});
  EXPECT_EQ(nameless.exit_code, 2);
  EXPECT_THAT(nameless.errors, HasSubstr("NAME.toml is required"));
  const auto without_ending = test::run_breccia(directory.path(), {"new", "mine"});
  EXPECT_EQ(without_ending.exit_code, 2);
  EXPECT_THAT(without_ending.errors, HasSubstr("mine: expected a name that ends in .toml"));
  const auto nowhere = test::run_breccia(directory.path(), {"new", "none/mine.toml"});
  EXPECT_EQ(nowhere.exit_code, 4);
  EXPECT_THAT(nowhere.errors, HasSubstr("none/mine.toml"));
}

TEST(ExamplesCommand, ListsDecksThatCanBeRun) {
  const test::TemporaryDirectory directory;
  const auto list = test::run_breccia(directory.path(), {"examples"});
  ASSERT_EQ(list.exit_code, 0) << list.errors;
  EXPECT_THAT(list.output, HasSubstr("  model-composite.toml            Model composite\n"));
  EXPECT_THAT(list.output, HasSubstr("paper/fig10.toml"));
  const std::string start = "Decks in ";
  ASSERT_THAT(list.output, testing::StartsWith(start));
  const std::filesystem::path examples = list.output.substr(start.size(), list.output.find(" (") - start.size());
  const auto check = test::run_breccia(
      directory.path(), {"check", (examples / "pbx9501-hb1.toml").string(), "--set", "tests.method=quasistatic"});
  EXPECT_EQ(check.exit_code, 0) << check.errors;
}

}  // namespace
}  // namespace breccia
