#include "studio/example_decks.hpp"

#include <algorithm>
#include <cstddef>
#include <set>
#include <sstream>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "deckfile/deck.hpp"
#include "io/file_mistakes.hpp"
#include "io/text_file.hpp"
#include "studio/replaced_parts.hpp"

namespace breccia::studio {
namespace {

namespace fs = std::filesystem;

/// The comment with which a text begins, up to an empty line of it, without the marks and as one line.
std::string first_comment(const std::string& text) {
  std::istringstream lines(text);
  std::string comment;
  for (std::string line; std::getline(lines, line) && line.starts_with("# ");) {
    if (!comment.empty()) comment += ' ';
    comment += line.substr(2);
  }
  return comment;
}

/// The texts of a deck that name an existing file beside it, in the order of the deck.
std::vector<std::string> named_files(const Deck& deck, const fs::path& directory) {
  std::set<std::string> names;
  for (const auto& [path, value] : deck.values()) {
    // Also within an inline array: every text in quotes.
    for (std::size_t begin = value.find('"'); begin != std::string::npos;) {
      const auto end = value.find('"', begin + 1);
      if (end == std::string::npos) break;
      const auto text = value.substr(begin + 1, end - begin - 1);
      std::error_code failure;
      if (!text.empty() && fs::is_regular_file(directory / text, failure)) names.insert(text);
      begin = value.find('"', end + 1);
    }
  }
  return {names.begin(), names.end()};
}

}  // namespace

std::vector<ExampleDeck> example_decks(const fs::path& examples) {
  std::vector<ExampleDeck> decks;
  for (const auto& entry : fs::recursive_directory_iterator(examples)) {
    if (entry.path().extension() != ".toml") continue;
    const Deck deck(entry.path());
    const auto title = deck.root().optional_text("title");
    if (!title) continue;  // a part of a deck, such as a material
    decks.push_back({entry.path().lexically_relative(examples).generic_string(), *title, first_comment(deck.text())});
  }
  std::ranges::sort(decks, {}, [](const ExampleDeck& deck) {
    return std::tuple(!deck.name.starts_with("materials/"), std::ranges::count(deck.name, '/'), deck.name);
  });
  return decks;
}

DeckText copy_example(const fs::path& examples, const std::string& example, Folder& folder, const std::string& name) {
  const auto known = example_decks(examples);
  if (std::ranges::find(known, example, &ExampleDeck::name) == known.end()) {
    throw InputError(fmt::format("{}: no such example", shown_value(example)));
  }
  folder.require_new_deck(name);
  const auto directory = (examples / example).parent_path();
  const Deck deck(examples / example);
  auto text = deck.text();
  for (const auto& file : named_files(deck, directory)) {
    const auto beside = fs::path(file).filename().string();
    folder.add_data(beside, read_text(directory / file));
    text = replaced(std::move(text), fmt::format("\"{}\"", file), fmt::format("\"{}\"", beside));
  }
  return folder.add_deck(name, text);
}

}  // namespace breccia::studio
