#include "deckfile/deck_differences.hpp"

#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace breccia {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;
using testing::SizeIs;

Deck deck_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return Deck::from_text(text, "study", ".", overrides);
}

TEST(DeckValues, HavePathsAsOverridesHave) {
  const auto deck = deck_of(R"(
title = "x"
[materials."type 2.1"]
shear = { terms = [{ time = "1 s", modulus = "2 Pa" }] }
[[stages]]
name = "A"
cells = 40
[tests]
loads = ["shear", "bulk"]
)",
                            {"stages.A.cells=60"});
  EXPECT_THAT(
      deck.values(),
      ElementsAre(Pair("title", "\"x\""), Pair("materials.\"type 2.1\".shear.terms.0.time", "\"1 s\""),
                  Pair("materials.\"type 2.1\".shear.terms.0.modulus", "\"2 Pa\""), Pair("stages.A.name", "\"A\""),
                  Pair("stages.A.cells", "60"), Pair("tests.loads", "[\"shear\", \"bulk\"]")));
}

TEST(DeckDifferences, AreThoseOfValues) {
  std::vector<Deck> decks;
  decks.push_back(deck_of("a = 1\nb = 2 # a comment\n"));
  decks.push_back(deck_of("b = 2\na = 1\n"));
  EXPECT_THAT(deck_differences(decks), IsEmpty()) << "comments and the order of keys are none";
  decks.push_back(deck_of("a = 1.5\nc = true\n"));
  const auto differences = deck_differences(decks);
  ASSERT_THAT(differences, SizeIs(3));
  EXPECT_EQ(differences[0].path, "a");
  EXPECT_THAT(differences[0].texts, ElementsAre("1", "1", "1.5"));
  EXPECT_EQ(differences[1].path, "b");
  EXPECT_THAT(differences[1].texts, ElementsAre("2", "2", ""));
  EXPECT_EQ(differences[2].path, "c");
  EXPECT_THAT(differences[2].texts, ElementsAre("", "", "true"));
}

TEST(FileDifferences, AreThoseOfContents) {
  const auto differences =
      file_differences({{{"a.csv", "1234567890"}, {"b.csv", "0"}}, {{"a.csv", "abcdefghij"}, {"b.csv", "0"}}});
  ASSERT_THAT(differences, SizeIs(1));
  EXPECT_EQ(differences[0].path, "file a.csv");
  EXPECT_THAT(differences[0].texts, ElementsAre("12345678", "abcdefgh"));
}

}  // namespace
}  // namespace breccia
