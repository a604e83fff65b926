#include <string>

#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "deckfile/deck_text_edit.hpp"
#include "messages.hpp"

namespace breccia {
namespace {

/// The text of a deck without the value at a path.
std::string without(const std::string& text, const DeckPath& path) {
  return deck_without(text, path);
}

TEST(DeckTextRemoval, AKeyGoesWithItsLines) {
  EXPECT_EQ(without("# above\nx = 1 # with it\n# below\ny = 2\n", {"x"}), "# above\n# below\ny = 2\n");
  EXPECT_EQ(without("[a]\nx = [\n  1, # one\n]\ny = 2\n", {"a", "x"}), "[a]\ny = 2\n");
  EXPECT_EQ(without("x = 1\ny = 2", {"y"}), "x = 1\n");
  EXPECT_EQ(without("x = 1\r\ny = \"\"\"\r\nz = 1\"\"\"\r\n\r\n", {"y"}), "x = 1\r\n\r\n");
  EXPECT_EQ(without("\xef\xbb\xbfx = 1\ny = 2\n", {"x"}), "\xef\xbb\xbfy = 2\n");
}

TEST(DeckTextRemoval, DottedKeysGoTogether) {
  EXPECT_EQ(without("a.b = 1\n# of c\na.c.d = 2\ne = 3\na.f = 4\n", {"a"}), "# of c\ne = 3\n");
  EXPECT_EQ(without("a.b = 1\na.c.d = 2\n", {"a", "c", "d"}), "a.b = 1\n");
  EXPECT_EQ(without("i = { a.b = 1, c = 2, a.d = 3 }\n", {"i", "a"}), "i = { c = 2 }\n");
  EXPECT_EQ(without("[f]\na.c = 1\nx = 1\n[f.a.t]\ns = 1\n", {"f", "a"}), "[f]\nx = 1\n");
}

TEST(DeckTextRemoval, AnEntryInBracesGoesWithItsComma) {
  EXPECT_EQ(without("a = { x = 1, y = 2, z = 3 }\n", {"a", "x"}), "a = { y = 2, z = 3 }\n");
  EXPECT_EQ(without("a = { x = 1, y = 2, z = 3 }\n", {"a", "y"}), "a = { x = 1, z = 3 }\n");
  EXPECT_EQ(without("a = { x = 1, y = 2, z = 3 }\n", {"a", "z"}), "a = { x = 1, y = 2 }\n");
  EXPECT_EQ(without("a = { x = 1 } # c\n", {"a", "x"}), "a = {} # c\n");
  EXPECT_EQ(without("a = { x = [\n1, # }\n], y = { z = 1 } }\n", {"a", "x"}), "a = { y = { z = 1 } }\n");
  EXPECT_EQ(without("a = { x = [\n1, # }\n], y = { z = 1 } }\n", {"a", "y", "z"}),
            "a = { x = [\n1, # }\n], y = {} }\n");
}

TEST(DeckTextRemoval, AnElementInBracketsGoesWithItsComma) {
  EXPECT_EQ(without("a = [1, 2, 3]\n", {"a", 0U}), "a = [2, 3]\n");
  EXPECT_EQ(without("a = [1, 2, 3]\n", {"a", 1U}), "a = [1, 3]\n");
  EXPECT_EQ(without("a = [1, 2, 3]\n", {"a", 2U}), "a = [1, 2]\n");
  EXPECT_EQ(without("a = [1, 2, ]\n", {"a", 1U}), "a = [1, ]\n");
  EXPECT_EQ(without("a = [ 1, ]\n", {"a", 0U}), "a = []\n");
  EXPECT_EQ(without("a = [1,\n  2]\n", {"a", 1U}), "a = [1]\n");
  EXPECT_EQ(without("a = [1, # one\n  2]\n", {"a", 1U}), "a = [1, # one\n  ]\n");
  EXPECT_EQ(without("a = [1, # one\n  2]\n", {"a", 0U}), "a = [ # one\n  2]\n");
  EXPECT_EQ(without("a = [\n  1, # one\n  2, # two\n  3 # three\n]\n", {"a", 1U}),
            "a = [\n  1, # one\n  3 # three\n]\n");
  EXPECT_EQ(without("a = [\n  1, # one\n  2, # two\n  3 # three\n]\n", {"a", 2U}),
            "a = [\n  1, # one\n  2, # two\n]\n");
  EXPECT_EQ(without("a = [\n  1, 2,\n  3, 4,\n]\n", {"a", 1U}), "a = [\n  1,\n  3, 4,\n]\n");
  EXPECT_EQ(without("a = [\n  1, 2,\n  3, 4,\n]\n", {"a", 2U}), "a = [\n  1, 2, 4,\n]\n");
  EXPECT_EQ(without("a = [\n  1,\n]\n", {"a", 0U}), "a = [\n]\n");
}

TEST(DeckTextRemoval, ABlockGoesWithItsSubBlocksUpToTheNextHeader) {
  EXPECT_EQ(without("[a]\nx = 1\n\n# of b\n[b] # head\ny = 1\n# on b\n\n# of s\n[b.s]\nz = 1\n\n# of c\n[c]\n", {"b"}),
            "[a]\nx = 1\n\n# of b\n\n# of c\n[c]\n");
}

TEST(DeckTextRemoval, CommentsApartFromABlockStay) {
  EXPECT_EQ(without("[a]\nx = 1\n\n[b]\ny = 1\n# on b\n\n# on nothing\n\n[c]\n", {"b"}),
            "[a]\nx = 1\n\n# on nothing\n\n[c]\n");
  EXPECT_EQ(without("[b]\ny = 1\n# of c\n[c]\n", {"b"}), "# of c\n[c]\n");
  EXPECT_EQ(without("[a]\n\n[b]\ny = 1\n\n# the end\n", {"b"}), "[a]\n\n# the end\n");
}

TEST(DeckTextRemoval, EmptyLinesAroundABlockGoOnOneSide) {
  EXPECT_EQ(without("[a]\nx = 1\n\n[b]\ny = 1\n\n[c]\n", {"b"}), "[a]\nx = 1\n\n[c]\n");
  EXPECT_EQ(without("[a]\nx = 1\n\n[b]\ny = 1\n", {"b"}), "[a]\nx = 1\n");
  EXPECT_EQ(without("[a]\r\nx = 1\r\n\r\n[b]\r\ny = 1", {"b"}), "[a]\r\nx = 1\r\n");
  EXPECT_EQ(without("[a]\nx = 1\n\n[b]\n", {"a"}), "[b]\n");
  EXPECT_EQ(without("[a]\nx = 1\n[b]\n\n[c]\n", {"b"}), "[a]\nx = 1\n\n[c]\n");
  EXPECT_EQ(without("[a]\n", {"a"}), "");
}

TEST(DeckTextRemoval, ATableThatIsScatteredGoesWhole) {
  EXPECT_EQ(without("[m.a]\nx = 1\n\n[t]\n\n[m.b]\nx = 2\n", {"m"}), "[t]\n");
  EXPECT_EQ(without("[m.a]\nx = 1\n\n[t]\n\n[m.b]\nx = 2\n", {"m", "a"}), "[t]\n\n[m.b]\nx = 2\n");
}

TEST(DeckTextRemoval, AnElementGoesWithItsBlocks) {
  constexpr auto text =
      "[[s]]\nn = 1\n[[s.f]]\nx = 1\n\n[[s.f]]\nx = 2\n\n[s.p]\ny = 1\n\n[[s]]\nn = 2\n[s.p]\ny = 2\n";
  EXPECT_EQ(without(text, {"s", 0U}), "[[s]]\nn = 2\n[s.p]\ny = 2\n");
  EXPECT_EQ(without(text, {"s", 1U}), "[[s]]\nn = 1\n[[s.f]]\nx = 1\n\n[[s.f]]\nx = 2\n\n[s.p]\ny = 1\n");
  EXPECT_EQ(without(text, {"s", 0U, "f", 0U}),
            "[[s]]\nn = 1\n\n[[s.f]]\nx = 2\n\n[s.p]\ny = 1\n\n[[s]]\nn = 2\n[s.p]\ny = 2\n");
  EXPECT_EQ(without(text, {"s", 1U, "p"}),
            "[[s]]\nn = 1\n[[s.f]]\nx = 1\n\n[[s.f]]\nx = 2\n\n[s.p]\ny = 1\n\n[[s]]\nn = 2\n");
  EXPECT_EQ(without(text, {"s"}), "");
}

TEST(DeckTextRemoval, TheLastElementIsTheWholeArray) {
  EXPECT_EQ(without("a = 1\n\n[[s]]\nx = 1\n", {"s", 0U}), "a = 1\n");
  EXPECT_EQ(without("s = [{ x = 1 }]\n", {"s", 0U}), "s = []\n");
}

TEST(DeckTextRemoval, MistakesNameThePath) {
  const auto refusal = [](const DeckPath& path) {
    return test::message_of<InputError>([&] { deck_without("a = 1\n[[s]]\nx = 1\n", path); });
  };
  EXPECT_EQ(refusal({"b"}), "nothing to remove: the deck has no b");
  EXPECT_EQ(refusal({"s", 0U, "y"}), "nothing to remove: the deck has no s.0.y");
  EXPECT_EQ(refusal({"s", 1U}), "nothing to remove: the deck has no s.1");
  EXPECT_EQ(refusal({"s", 2U}), "s has no element 2: the next one is 1");
  EXPECT_EQ(refusal({"a", "b"}), "a is 1, no table and no array: it has no \"b\"");
  EXPECT_EQ(refusal({}), "expected a path of 1 to 100 steps, got 0");
}

}  // namespace
}  // namespace breccia
