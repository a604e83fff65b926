#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "command.hpp"
#include "documentation_page.hpp"
#include "io/text_file.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;
const fs::path root = BRECCIA_SOURCE_DIRECTORY;

/// A line with only dots stands for any lines.
bool is_ellipsis(const std::string& line) {
  return line.find_first_not_of(" .") == std::string::npos;
}

/// Expects these lines in a text, in this order.
void expect_lines_in_order(const std::vector<std::string>& lines, const std::string& text) {
  const auto printed = fmt::format("\n{}", test::without_times(text));
  std::size_t from = 0;
  for (const auto& line : lines) {
    if (is_ellipsis(line)) continue;
    const auto found = printed.find(fmt::format("\n{}\n", test::without_times(line)), from);
    EXPECT_NE(found, std::string::npos) << "quoted: " << line << "\nprinted: " << text;
    if (found == std::string::npos) return;
    from = found + 1;
  }
}

/// The number of threads changes no result, only how long it takes beside other tests.
std::vector<std::string> on_one_thread(std::vector<std::string> arguments) {
  const bool takes_threads = arguments.front() == "run" || arguments.front() == "pack";
  if (takes_threads && std::ranges::count(arguments, "--threads") == 0) {
    arguments.insert(arguments.end(), {"--threads", "1"});
  }
  return arguments;
}

/// Whether a page quotes the output of a command, or a later command works with its results.
bool is_needed(const std::vector<test::DocumentedCommand>& commands, std::size_t index) {
  const auto& arguments = commands[index].arguments;
  const auto out = std::ranges::find(arguments, "--out");
  const auto works_with_results = [&](const test::DocumentedCommand& later) {
    return out != arguments.end() && later.arguments.size() > 1 && later.arguments[1] == *(out + 1);
  };
  return !commands[index].output.empty() ||
         std::any_of(commands.begin() + static_cast<std::ptrdiff_t>(index) + 1, commands.end(), works_with_results);
}

/// Runs the commands of a page of the documentation, and compares the quoted output with the printed one.
void follow(const fs::path& markdown) {
  const auto page = test::read_documentation(read_text(markdown));
  ASSERT_FALSE(page.commands.empty());
  const test::TemporaryDirectory directory;
  for (const auto* name : {"examples", "data"}) fs::create_directory_symlink(root / name, directory.path() / name);
  for (const auto& [name, text] : page.files) directory.write(name, text);
  for (std::size_t i = 0; i < page.commands.size(); ++i) {
    if (!is_needed(page.commands, i)) continue;
    const auto& [arguments, output] = page.commands[i];
    SCOPED_TRACE(testing::PrintToString(arguments));
    const auto outcome = test::run_breccia(directory.path(), on_one_thread(arguments));
    // For a command that is refused the page quotes the error message.
    const bool is_refused = outcome.exit_code != 0 && outcome.output.empty() && !output.empty();
    EXPECT_TRUE(outcome.exit_code == 0 || is_refused) << outcome.errors;
    expect_lines_in_order(output, outcome.output + outcome.errors);
  }
}

TEST(Documentation, TheTutorialQuotesWhatIsPrinted) {
  follow(root / "docs" / "tutorial.md");
}

TEST(Documentation, ThePageOnDesignQuotesWhatIsPrinted) {
  follow(root / "docs" / "design.md");
}

TEST(Documentation, TheTutorialOfImagesQuotesWhatIsPrinted) {
  follow(root / "docs" / "tutorial-image.md");
}

TEST(Documentation, TheTutorialOnCoatingsQuotesWhatIsPrinted) {
  follow(root / "docs" / "tutorial-coatings.md");
}

TEST(Documentation, ThePageOnCalibrationQuotesWhatIsPrinted) {
  follow(root / "docs" / "calibration.md");
}

TEST(Documentation, ThePageOnUncertaintyQuotesWhatIsPrinted) {
  follow(root / "docs" / "uncertainty.md");
}

TEST(Documentation, ThePageOnFittingQuotesWhatIsPrinted) {
  follow(root / "docs" / "fitting.md");
}

TEST(Documentation, TheReadmeQuotesWhatIsPrinted) {
  follow(root / "README.md");
}

/// The deck of `breccia new` is the first deck of the README with the spectrum of its binder in the deck itself.
TEST(Documentation, TheStarterGivesTheNumbersOfTheReadme) {
  const auto page = test::read_documentation(read_text(root / "README.md"));
  const test::TemporaryDirectory directory;
  for (const auto& [name, text] : page.files) directory.write(name, text);
  ASSERT_EQ(test::run_breccia(directory.path(), {"new", "starter.toml"}).exit_code, 0);
  for (const auto* deck : {"starter.toml", "composite.toml"}) {
    const auto run = test::run_breccia(directory.path(), {"run", deck, "--threads", "1", "--quiet"});
    ASSERT_EQ(run.exit_code, 0) << run.errors;
  }
  const auto results = directory.path() / "results";
  EXPECT_EQ(read_text(results / "starter" / "curves.csv"), read_text(results / "composite" / "curves.csv"));
}

}  // namespace
}  // namespace breccia
