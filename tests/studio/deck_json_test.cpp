#include "studio/deck_json.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "breccia/error.hpp"

#include "messages.hpp"

namespace breccia::studio {
namespace {

using nlohmann::json;

/// The node of the first entry of a deck.
json first_value(const std::string& text) {
  return deck_tree_json(text).at("entries").at(0).at("value");
}

TEST(DeckJson, ScalarsHaveTypeLineAndValue) {
  EXPECT_EQ(first_value("\n\na = \"2 mm\" # c\n"), (json{{"type", "text"}, {"line", 3}, {"value", "2 mm"}}));
  EXPECT_EQ(first_value("a = 64"), (json{{"type", "integer"}, {"line", 1}, {"value", 64}}));
  EXPECT_EQ(first_value("a = 0.5"), (json{{"type", "number"}, {"line", 1}, {"value", 0.5}}));
  EXPECT_EQ(first_value("a = true"), (json{{"type", "boolean"}, {"line", 1}, {"value", true}}));
  EXPECT_EQ(first_value("a = 2024-01-31"), (json{{"type", "date"}, {"line", 1}}));
}

TEST(DeckJson, AWholeNumberStaysANumber) {
  EXPECT_EQ(first_value("a = 1.0").dump(), R"({"line":1,"type":"number","value":1.0})");
  EXPECT_EQ(first_value("a = 9223372036854775807").dump(),
            R"({"line":1,"type":"integer","value":9223372036854775807})");
}

TEST(DeckJson, NumbersThatJsonLacksAreTexts) {
  EXPECT_EQ(first_value("a = inf"), (json{{"type", "number"}, {"line", 1}, {"value", "inf"}}));
  EXPECT_EQ(first_value("a = -inf").at("value"), "-inf");
  EXPECT_EQ(first_value("a = nan").at("value"), "nan");
  EXPECT_EQ(first_value("a = -nan").at("value"), "nan");
}

TEST(DeckJson, ArraysHaveItems) {
  EXPECT_EQ(first_value("a = [\n  1,\n  [],\n]"), json::parse(R"({"type": "array", "line": 1, "items": [
              {"type": "integer", "line": 2, "value": 1}, {"type": "array", "line": 3, "items": []}]})"));
  EXPECT_EQ(first_value("[[stages]]\n[[stages]]\n"), json::parse(R"({"type": "array", "line": 1, "items": [
              {"type": "table", "line": 1, "inline": false, "entries": []},
              {"type": "table", "line": 2, "inline": false, "entries": []}]})"));
}

TEST(DeckJson, TablesHaveEntriesInTheOrderOfTheDeck) {
  const auto tree = deck_tree_json("z = 1\na = 2\n[t]\nc = 3\nb = 4\n");
  EXPECT_EQ(tree.at("type"), "table");
  std::string keys;
  for (const auto& entry : tree.at("entries")) keys += entry.at("key").get<std::string>();
  for (const auto& entry : tree.at("entries").at(2).at("value").at("entries"))
    keys += entry.at("key").get<std::string>();
  EXPECT_EQ(keys, "zatcb");
}

TEST(DeckJson, OnlyTablesInBracesAreInline) {
  EXPECT_FALSE(deck_tree_json("").at("inline"));
  EXPECT_TRUE(first_value("a = {}").at("inline"));
  EXPECT_TRUE(first_value("a = [{ x = 1 }]").at("items").at(0).at("inline"));
  EXPECT_FALSE(first_value("[a]").at("inline"));
  EXPECT_FALSE(first_value("a.b = 1").at("inline"));
  EXPECT_FALSE(first_value("[a.b]").at("inline"));
}

TEST(DeckJson, ATextThatIsNotTomlIsRefused) {
  EXPECT_THAT(test::message_of<InputError>([] { deck_tree_json("a = 1\nb\n"); }), testing::HasSubstr("deck:2:"));
}

}  // namespace
}  // namespace breccia::studio
