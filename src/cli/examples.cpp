#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "cli/command.hpp"
#include "cli/installation.hpp"
#include "io/text_file.hpp"

namespace breccia::cli {
namespace {

namespace fs = std::filesystem;

/// The title in the line `title = "..."` of a deck; empty if there is no such line.
std::string title_of(const std::string& deck) {
  const auto line = deck.starts_with("title") ? 0 : deck.find("\ntitle");
  const auto begin = deck.find('"', line);
  const auto end = begin == std::string::npos ? begin : deck.find('"', begin + 1);
  return line == std::string::npos || end == std::string::npos ? "" : deck.substr(begin + 1, end - begin - 1);
}

/// The decks in a directory and its subdirectories, in alphabetical order, those of the directory itself first.
std::vector<fs::path> decks_below(const fs::path& directory) {
  std::vector<fs::path> decks;
  for (const auto& entry : fs::recursive_directory_iterator(directory)) {
    if (entry.path().extension() == ".toml") decks.push_back(entry.path().lexically_relative(directory));
  }
  std::ranges::sort(decks, [](const fs::path& a, const fs::path& b) {
    const bool a_is_deeper = a.has_parent_path(), b_is_deeper = b.has_parent_path();
    return a_is_deeper != b_is_deeper ? b_is_deeper : a < b;
  });
  return decks;
}

constexpr auto pages = R"(  README.md               an overview of all pages
  tutorial.md             the first half hour
  tutorial-image.md       from a micrograph to G(t)
  glossary.md             the words and symbols
  boundary-conditions.md  which boundary condition, and how large a box
  decks.md                every key of a deck
  results.md              every file that a run writes
  fitting.md              from measured data to a Prony series
)";

void print_examples() {
  const auto examples = installed_examples();
  const auto documentation = installed_documentation();
  fmt::print("Decks in {} (run one by its path, or copy it):\n", examples.string());
  for (const auto& deck : decks_below(examples)) {
    fmt::print("  {:<30}  {}\n", deck.string(), title_of(read_text(examples / deck)));
  }
  fmt::print(
      "A copy of a deck that names files in ../data/ needs a copy of {}\n"
      "beside the folder of the deck; without it the deck is refused.\n",
      (examples.parent_path() / "data").string());
  fmt::print("\nDocumentation in {}:\n", (documentation / "docs").string());
  fmt::print("{}", pages);
}

}  // namespace

void add_examples(CLI::App& application) {
  auto* command = application.add_subcommand("examples", "list the decks and the documentation that came with breccia");
  command->callback(print_examples);
}

}  // namespace breccia::cli
