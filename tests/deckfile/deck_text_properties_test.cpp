#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "deckfile/deck.hpp"
#include "deckfile/deck_text_edit.hpp"
#include "deckfile/deck_text_place.hpp"
#include "deckfile/deck_text_scan.hpp"
#include "deckfile/deck_tree_edit.hpp"
#include "io/text_file.hpp"

namespace breccia {
namespace {

using detail::DeckArray;
using detail::DeckTable;
using detail::DeckValue;

struct NamedDeck {
  std::string name;
  std::string text;
};

/// All decks of examples/, and texts with what these have not.
std::vector<NamedDeck> decks() {
  std::vector<NamedDeck> decks{
      {"dotted", "a.b = 1 # one\na.c.d = '2'\n\n[t]\nx.y = { p.q = 1, p.r = 2, s = {} }\nx.z = []\n[t.x.w]\nv = 1\n"},
      {"nested",
       "[[s]]\n[[s.f]]\nx=1\n[s.f.g]\ny=[[1,2],[{z=1}]]\n[[s.f]]\n[[s]]\nn='''\n[x]'''\n[s.p]\n[t.u]\nv=1\n[t]\n"},
      {"windows",
       "\xef\xbb\xbf\"µ m\" = \"ü\"\r\n\r\n# c\r\n[t.\"a.b\"]\r\nx   = [\r\n  1, # one\r\n  2  # two\r\n]\r\nyyy = 3"},
      {"scattered", "[m.a]\nx = 1\n# on a\n[t]\ny = inf\n# on m\n\n[m.b]\nx = -nan\n[m]\nz = true\n\n# end\n"}};
  for (const auto& file : std::filesystem::recursive_directory_iterator(BRECCIA_EXAMPLES_DIRECTORY)) {
    if (file.path().extension() == ".toml") decks.push_back({file.path().string(), read_text(file.path())});
  }
  return decks;
}

/// Collects the paths of all values in a table, tables and arrays among them.
void add_paths(const DeckPath& path, const DeckValue& value, std::vector<DeckPath>& paths) {
  if (!path.empty()) paths.push_back(path);
  if (const auto* table = std::get_if<DeckTable>(&value.content)) {
    for (const auto& entry : table->entries) add_paths(detail::extended(path, DeckStep(entry.key)), entry.value, paths);
  }
  if (const auto* array = std::get_if<DeckArray>(&value.content)) {
    for (std::size_t i = 0; i < array->values.size(); ++i) {
      add_paths(detail::extended(path, DeckStep(i)), array->values[i], paths);
    }
  }
}

std::vector<DeckPath> paths_of(const DeckTable& root) {
  std::vector<DeckPath> paths;
  add_paths({}, {{}, root}, paths);
  return paths;
}

/// The value as TOML, tables in braces.
std::string toml_of(const DeckValue& value) {
  if (const auto scalar = detail::scalar_of(value)) return toml_text(*scalar);
  std::vector<std::string> parts;
  if (const auto* array = std::get_if<DeckArray>(&value.content)) {
    for (const auto& element : array->values) parts.push_back(toml_of(element));
    return fmt::format("[{}]", fmt::join(parts, ", "));
  }
  for (const auto& entry : std::get<DeckTable>(value.content).entries) {
    parts.push_back(fmt::format("{} = {}", toml_text(entry.key), toml_of(entry.value)));
  }
  return fmt::format("{{ {} }}", fmt::join(parts, ", "));
}

/// The text of a value that stands in a line.
std::optional<std::string> source_of(const std::string& text, const DeckPath& path) {
  const auto source = detail::scanned(text);
  const auto* line = detail::line_of_value(source, path);
  const auto* value = line != nullptr ? detail::place_in_line(*line, path).value : nullptr;
  return value != nullptr ? std::optional(detail::part_of(text, value->span)) : std::nullopt;
}

/// The texts of all values, without their paths, which have the names of stages in them.
std::vector<std::string> values_of(const std::string& text) {
  std::vector<std::string> texts;
  for (const auto& value : Deck::from_text(text, "deck", ".").values()) texts.push_back(value.second);
  return texts;
}

/// Calls an action with each deck, its tree and each path in it.
template <class Action>
void for_all_values(const Action& action) {
  for (const auto& deck : decks()) {
    const auto root = detail::parse_deck(deck.name, deck.text);
    for (const auto& path : paths_of(root)) {
      SCOPED_TRACE(fmt::format("{}: {}", deck.name, detail::path_text(path)));
      action(deck.text, root, path);
    }
  }
}

TEST(DeckTextProperties, ThereAreDecks) {
  EXPECT_GT(decks().size(), 50U);
}

TEST(DeckTextProperties, AValueReplacedByItselfLeavesTheText) {
  for_all_values([](const std::string& text, const DeckTable& root, const DeckPath& path) {
    const auto source = source_of(text, path);
    EXPECT_EQ(deck_with_value(text, path, source ? *source : toml_of(*detail::value_at(root, path))), text);
  });
}

TEST(DeckTextProperties, AnotherScalarChangesOneValueAlone) {
  for_all_values([](const std::string& text, const DeckTable& root, const DeckPath& path) {
    if (!detail::scalar_of(*detail::value_at(root, path))) return;
    const auto changed = deck_with_value(text, path, "\"an edited text\"");
    const auto before = values_of(text);
    const auto after = values_of(changed);
    ASSERT_EQ(before.size(), after.size());
    std::size_t differences = 0;
    for (std::size_t i = 0; i < before.size(); ++i) differences += before[i] != after[i] ? 1U : 0U;
    EXPECT_EQ(differences, 1U);
    EXPECT_EQ(deck_with_value(changed, path, source_of(text, path).value()), text);
  });
}

TEST(DeckTextProperties, AValueRemovedAndAddedAgainIsTheSame) {
  for_all_values([](const std::string& text, const DeckTable& root, const DeckPath& path) {
    const auto* index = std::get_if<std::size_t>(&path.back());
    const auto around = detail::DeckSteps(path).first(path.size() - 1);
    if (index != nullptr) {
      const auto& array = std::get<DeckArray>(detail::value_at(root, around)->content);
      if (*index + 1 < array.values.size()) return;
    }
    const auto removed = deck_without(text, path);
    EXPECT_LT(removed.size(), text.size());
    const auto added = deck_with_value(removed, path, toml_of(*detail::value_at(root, path)));
    EXPECT_TRUE(detail::is_same(detail::parse_deck("deck", added), root)) << added;
  });
}

TEST(DeckTextProperties, AKeyRenamedAndRenamedBackLeavesTheValues) {
  for_all_values([](const std::string& text, const DeckTable& root, const DeckPath& path) {
    if (!std::holds_alternative<std::string>(path.back())) return;
    const auto around = detail::DeckSteps(path).first(path.size() - 1);
    const auto renamed = deck_with_key(text, path, "another key");
    const auto back =
        deck_with_key(renamed, detail::extended(around, DeckStep("another key")), std::get<std::string>(path.back()));
    EXPECT_TRUE(detail::is_same(detail::parse_deck("deck", back), root)) << back;
  });
}

TEST(DeckTextProperties, ElementsExchangedTwiceLeaveTheText) {
  std::size_t count = 0;
  for_all_values([&](const std::string& text, const DeckTable&, const DeckPath& path) {
    const auto* index = std::get_if<std::size_t>(&path.back());
    if (index == nullptr || *index == 0) return;
    const auto before = detail::extended(detail::DeckSteps(path).first(path.size() - 1), DeckStep(*index - 1));
    EXPECT_EQ(deck_with_exchange(deck_with_exchange(text, path, before), before, path), text);
    ++count;
  });
  EXPECT_GT(count, 100U);
}

TEST(DeckTextProperties, ANewEntryIsAllThatIsNew) {
  for_all_values([](const std::string& text, const DeckTable& root, const DeckPath& path) {
    if (detail::kind_of(*detail::value_at(root, path)) != Kind::table) return;
    for (const auto* value : {"1", "{ x = 1, y = \"2 mm\" }"}) {
      const auto added = deck_with_value(text, detail::extended(path, DeckStep("new")), value);
      std::size_t same = 0;
      while (same < text.size() && text[same] == added[same]) ++same;
      EXPECT_GT(added.size(), text.size());
      EXPECT_EQ(added.substr(added.size() - (text.size() - same)), text.substr(same));
    }
  });
}

}  // namespace
}  // namespace breccia
