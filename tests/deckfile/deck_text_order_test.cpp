#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "deckfile/deck_text_edit.hpp"
#include "messages.hpp"

namespace breccia {
namespace {

using testing::HasSubstr;

std::string with_key(const std::string& text, const DeckPath& path, const std::string& key) {
  return deck_with_key(text, path, key);
}

std::string key_refusal(const std::string& text, const DeckPath& path, const std::string& key) {
  return test::message_of<InputError>([&] { (void)deck_with_key(text, path, key); });
}

std::string exchange_refusal(const std::string& text, const DeckPath& one, const DeckPath& other) {
  return test::message_of<InputError>([&] { (void)deck_with_exchange(text, one, other); });
}

TEST(DeckWithKey, AKeyIsRenamedInItsLine) {
  EXPECT_EQ(with_key("a = 1 # one\n[t]\na.b = 2\n", {"a"}, "c"), "c = 1 # one\n[t]\na.b = 2\n");
  EXPECT_EQ(with_key("[t]\na.b = 2\na.c.d = 3\n", {"t", "a"}, "e f"), "[t]\n\"e f\".b = 2\n\"e f\".c.d = 3\n");
  EXPECT_EQ(with_key("[t]\na.b = 2\na.c.d = 3\n", {"t", "a", "c"}, "e"), "[t]\na.b = 2\na.e.d = 3\n");
  EXPECT_EQ(with_key("t = [{ a.b = 1, a.c = { b = 2 } }]\n", {"t", 0U, "a"}, "x"),
            "t = [{ x.b = 1, x.c = { b = 2 } }]\n");
  EXPECT_EQ(with_key("t = [{ a.b = 1, a.c = { b = 2 } }]\n", {"t", 0U, "a", "c", "b"}, "x"),
            "t = [{ a.b = 1, a.c = { x = 2 } }]\n");
}

TEST(DeckWithKey, AKeyIsRenamedInAllHeaders) {
  EXPECT_EQ(with_key("[m.a] # first\nx = 1\n[m.'a'.s]\ny = 2\n[[m.a.l]]\n[m.b.a]\n", {"m", "a"}, "c"),
            "[m.c] # first\nx = 1\n[m.c.s]\ny = 2\n[[m.c.l]]\n[m.b.a]\n");
  EXPECT_EQ(with_key("[[s]]\n[s.p]\nx = 1\n[[s]]\n[s.p]\nx = 2\n[s.p.q]\n", {"s", 1U, "p"}, "r"),
            "[[s]]\n[s.p]\nx = 1\n[[s]]\n[s.r]\nx = 2\n[s.r.q]\n");
  EXPECT_EQ(with_key("[[s.f]]\nx = 1\n[[s.f]]\n[s.f.g]\n", {"s", "f"}, "g"), "[[s.g]]\nx = 1\n[[s.g]]\n[s.g.g]\n");
}

TEST(DeckWithKey, TheSameKeyChangesNothing) {
  EXPECT_EQ(with_key("'a' = 1\n", {"a"}, "a"), "'a' = 1\n");
}

TEST(DeckWithKey, WhatCannotBeIsRefused) {
  EXPECT_THAT(key_refusal("a = 1\nb = 2\n", {"a"}, "b"), HasSubstr("a b already"));
  EXPECT_THAT(key_refusal("a = 1\n", {"b"}, "c"), HasSubstr("the deck has no b"));
  EXPECT_THAT(key_refusal("a = [1]\n", {"a", 0U}, "c"), HasSubstr("an element of an array"));
  EXPECT_THAT(key_refusal("a = 1\n", {"a"}, "\xff"), HasSubstr("expected keys of TOML"));
  EXPECT_THAT(key_refusal("a = \n", {"a"}, "b"), HasSubstr("not TOML"));
}

TEST(DeckWithExchange, BlocksChangePlacesWithTheirComments) {
  constexpr auto text = R"(title = "t"

# The first.
[[s]]
name = "a"  # its name
[s.p]
x = 1

# The second.
[[s]]
name = "b"

[t]
y = 2
)";
  constexpr auto exchanged = R"(title = "t"

# The second.
[[s]]
name = "b"

# The first.
[[s]]
name = "a"  # its name
[s.p]
x = 1

[t]
y = 2
)";
  EXPECT_EQ(deck_with_exchange(text, DeckPath{"s", 0U}, DeckPath{"s", 1U}), exchanged);
  EXPECT_EQ(deck_with_exchange(exchanged, DeckPath{"s", 1U}, DeckPath{"s", 0U}), text);
}

TEST(DeckWithExchange, TablesAndLinesOfATableChangePlaces) {
  EXPECT_EQ(deck_with_exchange("[m.a]\nx = 1\n[m.a.s]\n\n[t]\n\n[m.b]\ny = 2", DeckPath{"m", "a"}, DeckPath{"m", "b"}),
            "[m.b]\ny = 2\n\n[t]\n\n[m.a]\nx = 1\n[m.a.s]");
  EXPECT_EQ(
      deck_with_exchange("[m]\n# of a\na.x = 1\na.y = 2\nb = { x = 3 }\n", DeckPath{"m", "b"}, DeckPath{"m", "a"}),
      "[m]\nb = { x = 3 }\n# of a\na.x = 1\na.y = 2\n");
}

TEST(DeckWithExchange, ItemsOfALineChangePlaces) {
  EXPECT_EQ(
      deck_with_exchange("s = [\n  { a = 1 }, # one\n  { b = [2, 3] },\n]\n", DeckPath{"s", 0U}, DeckPath{"s", 1U}),
      "s = [\n  { b = [2, 3] }, # one\n  { a = 1 },\n]\n");
  EXPECT_EQ(deck_with_exchange("m = { a = 1, b = 2 }\n", DeckPath{"m", "a"}, DeckPath{"m", "b"}),
            "m = { b = 2, a = 1 }\n");
}

TEST(DeckWithExchange, WhatCannotBeIsRefused) {
  EXPECT_THAT(exchange_refusal("[a]\nx = 1\n[b]\ny = 1\n", {"a"}, {"b", "y"}), HasSubstr("not two of one table"));
  EXPECT_THAT(exchange_refusal("[a]\n[b]\n", {"a"}, {"a"}), HasSubstr("not two of one table"));
  EXPECT_THAT(exchange_refusal("[[a]]\n", {"a", 0U}, {"a", 1U}), HasSubstr("the deck has no a.1"));
  EXPECT_THAT(exchange_refusal("[m.a]\nx = 1\n[m.b]\n[m.a.s]\n", {"m", "a"}, {"m", "b"}),
              HasSubstr("its lines do not follow one another"));
  EXPECT_THAT(exchange_refusal("m = { a.x = 1, a.y = 2, b = 3 }\n", {"m", "a"}, {"m", "b"}),
              HasSubstr("its lines do not follow one another"));
  EXPECT_THAT(exchange_refusal("m.a.x = 1\n[m.b]\n", {"m", "a"}, {"m", "b"}), HasSubstr("in different ways"));
}

}  // namespace
}  // namespace breccia
