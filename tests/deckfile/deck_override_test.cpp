#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "deckfile/deck.hpp"
#include "messages.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

constexpr auto deck_text = R"(
[materials.binder]
bulk = "3.6 GPa"
[[stages]]
name = "HB-1"
cells = 300
times = ["1 s", "2 s"]
[[stages]]
name = "HB-2"
cells = 200
)";

class DeckOverride : public testing::Test {
 protected:
  [[nodiscard]] Deck read(const std::vector<std::string>& overrides) const {
    return Deck(directory.written("deck.toml", deck_text), overrides);
  }
  [[nodiscard]] std::string mistake(const std::string& override_text) const {
    const auto deck = read({override_text});
    return test::message_of<InputError>([&] {
      deck.root().accept_all_keys();
      deck.finish();
    });
  }

  test::TemporaryDirectory directory;
};

TEST_F(DeckOverride, ReplacesValuesByNameAndByIndex) {
  const auto deck = read({"stages.HB-1.cells=100", "stages.1.cells=50", "materials.binder.bulk=\"2 GPa\""});
  const auto stages = deck.root().sections("stages");
  EXPECT_EQ(stages.at(0).integer("cells"), 100);
  EXPECT_EQ(stages.at(1).integer("cells"), 50);
  EXPECT_EQ(deck.root().section("materials").section("binder").quantity("bulk", Dimension::pressure), 2e9);
}

TEST_F(DeckOverride, ReadsAValueAsTomlOrElseAsText) {
  const auto deck = read({"a=3.6 GPa", "b=[1, 2]", "c={ x = 1 }", "d=true", "e=it's = 2"});
  EXPECT_EQ(deck.root().quantity("a", Dimension::pressure), 3.6e9);
  EXPECT_THAT(deck.root().numbers("b"), testing::ElementsAre(1.0, 2.0));
  EXPECT_EQ(deck.root().section("c").integer("x"), 1);
  EXPECT_EQ(deck.root().optional_boolean("d"), true);
  EXPECT_EQ(deck.root().text("e"), "it's = 2");
}

TEST_F(DeckOverride, AddsNoFurtherKeys) {
  const auto deck = read({"e=1\nf = 2"});
  EXPECT_EQ(deck.root().text("e"), "");
  EXPECT_FALSE(deck.root().has("f"));
}

TEST_F(DeckOverride, ReachesElementsAndQuotedKeys) {
  const auto deck = read({"stages.HB-1.times.1=5 s", "\"a.b\".c=1"});
  EXPECT_THAT(deck.root().sections("stages").at(0).quantities("times", Dimension::time),
              testing::ElementsAre(1.0, 5.0));
  EXPECT_EQ(deck.root().section("a.b").integer("c"), 1);
}

TEST_F(DeckOverride, AnEmptyValueRemovesTheKey) {
  const auto deck = read({"stages.*.times=", "stages.HB-2.cells=", "materials.binder=", "stages.0.name=", "a=1", "a="});
  const auto stages = deck.root().sections("stages");
  EXPECT_EQ(stages.at(0).integer("cells"), 300);
  EXPECT_FALSE(stages.at(0).has("times") || stages.at(0).has("name") || stages.at(1).has("cells"));
  EXPECT_FALSE(deck.root().section("materials").has("binder") || deck.root().has("a"));
  EXPECT_EQ(stages.at(1).text("name"), "HB-2");
  EXPECT_NO_THROW(deck.finish()) << "the second stage has no times, and lacks none";
}

TEST_F(DeckOverride, WhatIsNotThereCannotBeRemoved) {
  EXPECT_THAT(mistake("stages.HB-3="), testing::HasSubstr("nothing to remove: stages has no \"HB-3\""));
  EXPECT_THAT(mistake("stages.HB-1.cell="), testing::HasSubstr("stages.HB-1 has no \"cell\", did you mean \"cells\"?"));
  EXPECT_THAT(mistake("stages.HB-1.cells.x="), testing::HasSubstr("stages.HB-1.cells has no \"x\""));
}

TEST_F(DeckOverride, AStarIsEveryElementAndEveryEntry) {
  const auto deck = read({"stages.*.cells=40", "stages.HB-1.times.*=3 s", "materials.*.bulk=1 GPa"});
  const auto stages = deck.root().sections("stages");
  EXPECT_EQ(stages.at(0).integer("cells"), 40);
  EXPECT_EQ(stages.at(1).integer("cells"), 40);
  EXPECT_THAT(stages.at(0).quantities("times", Dimension::time), testing::ElementsAre(3.0, 3.0));
  EXPECT_EQ(deck.root().section("materials").section("binder").quantity("bulk", Dimension::pressure), 1e9);
}

TEST_F(DeckOverride, MakesTablesOnTheWay) {
  const auto deck = read({"tests.dynamic.courant=0.5"});
  EXPECT_EQ(deck.root().section("tests").section("dynamic").number("courant"), 0.5);
}

TEST_F(DeckOverride, LaterOnesWin) {
  const auto deck = read({"stages.HB-1.cells=1", "stages.HB-1.cells=2"});
  EXPECT_EQ(deck.root().sections("stages").at(0).integer("cells"), 2);
}

TEST_F(DeckOverride, MistakesNameTheOverride) {
  EXPECT_EQ(mistake("title"), "--set title: expected key.path=value, such as \"stages.HB-1.cells=100\"");
  EXPECT_EQ(mistake("=3"), "--set =3: expected key.path=value, such as \"stages.HB-1.cells=100\"");
  EXPECT_EQ(mistake("a..b=3"), "--set a..b=3: expected key.path=value, such as \"stages.HB-1.cells=100\"");
  EXPECT_EQ(mistake("a="), "--set a=: nothing to remove: the deck has no \"a\"; known: \"materials\", \"stages\"");
  EXPECT_EQ(mistake("stages.HB1.cells=3"),
            "--set stages.HB1.cells=3: stages has no entry \"HB1\", did you mean \"HB-1\"?");
  EXPECT_EQ(mistake("stages.7.cells=3"),
            "--set stages.7.cells=3: stages has no entry \"7\"; known: \"HB-1\", \"HB-2\"");
  EXPECT_EQ(
      mistake("materials.binder.bulk.prony=x"),
      "--set materials.binder.bulk.prony=x: materials.binder.bulk is \"3.6 GPa\", not a table: it has no \"prony\"");
}

TEST_F(DeckOverride, MistakesBehindAStar) {
  EXPECT_EQ(mistake("stages.*.cells.x=3"),
            "--set stages.*.cells.x=3: stages.HB-1.cells is 300, not a table: it has no \"x\"\n"
            "--set stages.*.cells.x=3: stages.HB-2.cells is 200, not a table: it has no \"x\"");
  EXPECT_EQ(mistake("tests.*.courant=3"), "--set tests.*.courant=3: tests has no entries for \"*\"");
}

TEST_F(DeckOverride, WrongValuesNameTheOverride) {
  const auto deck = read({"materials.binder.bulk=3.6 um"});
  EXPECT_TRUE(std::isnan(deck.root().section("materials").section("binder").quantity("bulk", Dimension::pressure)));
  deck.root().accept_all_keys();
  EXPECT_EQ(test::message_of<InputError>([&] { deck.finish(); }),
            "--set materials.binder.bulk=3.6 um: materials.binder.bulk: expected a pressure, got \"3.6 um\"");
}

TEST_F(DeckOverride, ASettingReturnsTheReplacedPaths) {
  Deck deck = read({});
  EXPECT_THAT(deck.set({"stages.*.cells", {}, {std::int64_t{7}, {}}}),
              testing::ElementsAre("stages.HB-1.cells", "stages.HB-2.cells"));
  EXPECT_EQ(deck.root().sections("stages").at(1).integer("cells"), 7);
}

TEST_F(DeckOverride, TheContentKnowsNoCommentsAndNoKeyLeftOut) {
  const auto content = [&](const std::string& text) {
    return Deck(directory.written("deck.toml", text)).content_without("sweep");
  };
  EXPECT_EQ(content("a = [1, \"b\"]\n"), content("# A comment\na=[ 1, 'b' ]\n[sweep]\nc = 1\n"));
  EXPECT_NE(content("a = 1"), content("a = 1.0"));
  EXPECT_NE(content("a = 'b'"), content("a = 'c'"));
}

TEST(SplitPath, RefusesStepsWithoutEnd) {
  std::string path = "a";
  for (int step = 0; step < 99; ++step) path += ".a";
  EXPECT_EQ(split_path(path).value().size(), 100U);
  EXPECT_FALSE(split_path(path + ".a"));
}

TEST(TomlText, ReadsBackAsTheSame) {
  const test::TemporaryDirectory directory;
  const std::vector<Scalar> values{true, std::int64_t{-3}, 2.0, 0.1, 1e300, std::string(R"(a "b" \)")};
  for (const auto& value : values) {
    const Deck deck(directory.written("deck.toml", "a = [" + toml_text(value) + "]"));
    EXPECT_EQ(deck.root().scalars("a").at(0).value, value) << toml_text(value);
  }
}

}  // namespace
}  // namespace breccia
