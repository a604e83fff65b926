#include "deckfile/deck.hpp"

#include <cmath>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "messages.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsNan;

class DeckTest : public testing::Test {
 protected:
  [[nodiscard]] Deck read(std::string_view text) const { return Deck(directory.written("deck.toml", text)); }
  [[nodiscard]] std::string without_directory(const std::string& message) const {
    return test::replaced(message, directory.path().string() + "/", "");
  }
  [[nodiscard]] std::string mistakes(const Deck& deck) const {
    return without_directory(test::message_of<InputError>([&] { deck.finish(); }));
  }

  test::TemporaryDirectory directory;
};

TEST_F(DeckTest, ReadsTypedValues) {
  directory.write("data.csv", "");
  const auto deck = read(R"(
text = "hello"
number = 0.65
whole = 3
flag = false
length = "48 um"
times = ["10 ns", "10 ms"]
factors = [1, 2.5]
file = "data.csv"
colour = "red"
colours = ["blue", "red"]
)");
  const auto root = deck.root();
  const std::vector<Choice<int>> colours{{"red", 1}, {"blue", 2}};
  EXPECT_EQ(root.text("text"), "hello");
  EXPECT_EQ(root.number("number"), 0.65);
  EXPECT_EQ(root.number("whole"), 3.0);
  EXPECT_EQ(root.integer("whole"), 3);
  EXPECT_EQ(root.optional_boolean("flag"), false);
  EXPECT_DOUBLE_EQ(root.quantity("length", Dimension::length), 48e-6);
  EXPECT_THAT(root.quantities("times", Dimension::time), ElementsAre(1e-8, 1e-2));
  EXPECT_THAT(root.numbers("factors"), ElementsAre(1.0, 2.5));
  EXPECT_EQ(root.file("file"), directory.path() / "data.csv");
  EXPECT_EQ(root.choice<int>("colour", colours), 1);
  EXPECT_THAT(root.list_of_choices<int>("colours", colours), ElementsAre(2, 1));
  EXPECT_EQ(root.optional_number("absent"), std::nullopt);
  EXPECT_FALSE(root.has("absent"));
  EXPECT_NO_THROW(deck.finish());
}

TEST_F(DeckTest, ReadsSections) {
  const auto deck = read("[a]\nx = 1\n[[b]]\nname = \"p\"\n[[b]]\nname = \"q\"\n");
  EXPECT_EQ(deck.root().section("a").integer("x"), 1);
  EXPECT_FALSE(deck.root().optional_section("c"));
  std::vector<std::string> names;
  for (const auto& entry : deck.root().sections("b")) names.push_back(entry.text("name"));
  EXPECT_THAT(names, ElementsAre("p", "q"));
  EXPECT_NO_THROW(deck.finish());
}

TEST_F(DeckTest, GathersAllMistakesInTheOrderOfTheLines) {
  const auto deck = read(R"([materials.binder]
bulk    = "3.6 um"
shear   = 3.6
denstiy = "1.48 g/cm^3"
[[stages]]
name = "HB-1"
cells = 1.5
fraction = 1.2
)");
  const auto stage = deck.root().sections("stages").at(0);
  static_cast<void>(stage.text("name"));
  EXPECT_EQ(stage.integer("cells"), 0);
  EXPECT_TRUE(std::isnan(stage.number("fraction", Range::between(0.0, 1.0))));
  EXPECT_TRUE(std::isnan(stage.quantity("box", Dimension::length)));
  const auto binder = deck.root().section("materials").section("binder");
  EXPECT_TRUE(std::isnan(binder.quantity("shear", Dimension::pressure)));
  EXPECT_TRUE(std::isnan(binder.quantity("bulk", Dimension::pressure)));
  EXPECT_EQ(binder.optional_quantity("density", Dimension::density), std::nullopt);
  EXPECT_EQ(mistakes(deck),
            "deck.toml:2:11: materials.binder.bulk: expected a pressure, got \"3.6 um\"\n"
            "deck.toml:3:11: materials.binder.shear: expected a pressure with its unit, such as \"3.6 GPa\", got 3.6\n"
            "deck.toml:4:1: materials.binder: unknown key \"denstiy\", did you mean \"density\"?\n"
            "deck.toml:5:1: stages.HB-1.box: missing, expected a length such as \"48 um\"\n"
            "deck.toml:7:9: stages.HB-1.cells: expected an integer, got 1.5\n"
            "deck.toml:8:12: stages.HB-1.fraction: expected a number between 0 and 1, got 1.2");
}

struct WrongValue {
  const char* text;
  void (*ask)(const Section&);
  const char* message;
};

TEST_F(DeckTest, MessagesNameTheExpectedValue) {
  const std::vector<WrongValue> cases{
      {"x = \"1\"", [](const Section& s) { static_cast<void>(s.number("x")); }, "expected a number, got \"1\""},
      {"x = nan", [](const Section& s) { static_cast<void>(s.number("x")); }, "expected a number, got nan"},
      {"x = inf", [](const Section& s) { static_cast<void>(s.number("x")); }, "expected a number, got inf"},
      {"x = 0", [](const Section& s) { static_cast<void>(s.number("x", Range::positive())); },
       "expected a positive number, got 0"},
      {"x = -1", [](const Section& s) { static_cast<void>(s.integer("x", Range::not_negative())); },
       "expected a non-negative integer, got -1"},
      {"x = 1", [](const Section& s) { static_cast<void>(s.integer("x", Range::at_least(2))); },
       "expected an integer of at least 2, got 1"},
      {"x = 0.0", [](const Section& s) { static_cast<void>(s.number("x", Range::above_and_up_to(0, 1))); },
       "expected a number above 0 and up to 1, got 0.0"},
      {"x = \"-1 um\"",
       [](const Section& s) { static_cast<void>(s.quantity("x", Dimension::length, Range::positive())); },
       "expected a positive length, got \"-1 um\""},
      {"x = 1", [](const Section& s) { static_cast<void>(s.optional_boolean("x")); }, "expected true or false, got 1"},
      {"x = true", [](const Section& s) { static_cast<void>(s.text("x")); }, "expected text in quotes, got true"},
      {"x = 2001-01-01", [](const Section& s) { static_cast<void>(s.text("x")); },
       "expected text in quotes, got a date or time"},
      {"x = \"none.csv\"", [](const Section& s) { static_cast<void>(s.file("x")); }, "no such file: none.csv"},
      {"x = \"rde\"",
       [](const Section& s) {
         static_cast<void>(s.choice<int>("x", {{"red", 1}, {"blue", 2}}));
       },
       R"(expected one of "red", "blue", got "rde", did you mean "red"?)"},
      {"x = 3",
       [](const Section& s) {
         static_cast<void>(s.choice<int>("x", {{"red", 1}}));
       },
       "expected \"red\" (nothing else is available), got 3"},
      {"x = \"1 s\"", [](const Section& s) { static_cast<void>(s.quantities("x", Dimension::time)); },
       R"(expected an array such as ["10 ns"], got "1 s")"},
      {"x = []", [](const Section& s) { static_cast<void>(s.numbers("x")); },
       "expected at least one, got an empty array"},
      {"x = 1", [](const Section& s) { static_cast<void>(s.section("x")); }, "expected a table, got 1"},
      {"x = {}", [](const Section& s) { static_cast<void>(s.sections("x")); },
       "expected an array of tables, got a table: write [[x]] in the place of [x]"},
      {"x = 150.0", [](const Section& s) { static_cast<void>(s.integer("x")); }, "expected an integer, got 150.0"},
      {R"(x = "a\nb")", [](const Section& s) { static_cast<void>(s.text("x")); },
       R"(expected text without line breaks, tabs and other control characters, got "a\u000ab")"},
      {R"(x = "a\tb")", [](const Section& s) { static_cast<void>(s.file("x")); },
       R"(expected text without line breaks, tabs and other control characters, got "a\u0009b")"},
  };
  for (const auto& wrong : cases) {
    const auto deck = read(wrong.text);
    wrong.ask(deck.root());
    EXPECT_EQ(mistakes(deck), std::string("deck.toml:1:5: x: ") + wrong.message) << wrong.text;
  }
}

TEST_F(DeckTest, PointsAtTheElementOfAnArray) {
  const auto deck = read("times = [\"1 s\",\n  \"2 m\"]\n");
  EXPECT_THAT(deck.root().quantities("times", Dimension::time), ElementsAre(1.0, IsNan()));
  EXPECT_EQ(mistakes(deck), "deck.toml:2:3: times: expected a time, got \"2 m\"");
}

TEST_F(DeckTest, AMissingSectionIsReportedOnce) {
  const auto deck = read("");
  const auto section = deck.root().section("tests");
  static_cast<void>(section.text("a"));
  static_cast<void>(section.section("b").number("c"));
  EXPECT_EQ(mistakes(deck), "deck.toml:1:1: tests: missing, expected a table");
}

TEST_F(DeckTest, ExactlyOneOfSeveralKeys) {
  const auto deck = read("[a]\nx = 1\n[b]\nx = 1\ny = 2\n[c]\n");
  const std::vector<std::string> keys{"x", "y"};
  EXPECT_EQ(deck.root().section("a").exactly_one(keys), "x");
  EXPECT_EQ(deck.root().section("b").exactly_one(keys), "");
  EXPECT_EQ(deck.root().section("c").exactly_one(keys), "");
  EXPECT_EQ(mistakes(deck),
            "deck.toml:5:5: b.y: expected exactly one of x, y, got x and y\n"
            "deck.toml:6:1: c: expected exactly one of x, y");
}

TEST_F(DeckTest, ReportsErrorsOfAnActionLineByLine) {
  const auto deck = read("file = \"a.csv\"\n");
  deck.root().report_errors_of("file", [] { throw InputError("a.csv:1: bad\na.csv:2: worse"); });
  EXPECT_EQ(mistakes(deck), "deck.toml:1:8: file: a.csv:1: bad\ndeck.toml:1:8: file: a.csv:2: worse");
}

TEST_F(DeckTest, UnknownKeysInSectionsThatWereAccepted) {
  const auto deck = read("[a]\nx = 1\n[b]\ny = 1\n");
  deck.root().section("a").accept_all_keys();
  static_cast<void>(deck.root().section("b"));
  EXPECT_EQ(mistakes(deck), "deck.toml:4:1: b: unknown key \"y\"");
}

TEST_F(DeckTest, SyntaxErrorsHaveAPlace) {
  for (const auto* text : {"a = \n", "[x\n", "a = 1\na = 2\n", "a = 48 um\n", "a = \"open\n"}) {
    const auto message = without_directory(test::message_of<InputError>([&] { static_cast<void>(read(text)); }));
    EXPECT_THAT(message, testing::MatchesRegex("deck.toml:[12]:[0-9]+: not TOML: .*")) << text;
  }
}

TEST_F(DeckTest, ListsOfTextHaveNoControlCharacters) {
  const auto deck = read("x = [1, \"a\\u0085b\"]\n");
  EXPECT_EQ(deck.root().scalars("x").size(), 1U);
  EXPECT_EQ(
      mistakes(deck),
      "deck.toml:1:9: x: expected text without line breaks, tabs and other control characters, got \"a\\u0085b\"");
}

TEST_F(DeckTest, TypographicQuotesAreNamed) {
  const auto mistake = [&](const char* text) {
    return without_directory(test::message_of<InputError>([&] { static_cast<void>(read(text)); }));
  };
  EXPECT_EQ(mistake("# “here”\nbulk = “2 GPa”\n"),
            "deck.toml:2:8: not TOML: the character “ is no quote of TOML: write \" in its place");
  EXPECT_THAT(mistake("a = [ \"“1”\", „2“ ]\n"), HasSubstr("the character „ is no quote of TOML"));
  EXPECT_THAT(mistake("a = \"“1”\" x\n"), testing::Not(HasSubstr("no quote of TOML")));
}

TEST_F(DeckTest, OtherEncodingsAreNamed) {
  using namespace std::string_literals;
  const auto mistake = [&](const std::string& text) {
    return without_directory(test::message_of<InputError>([&] { static_cast<void>(read(text)); }));
  };
  EXPECT_EQ(mistake("\xff\xfe"
                    "a\0 \0=\0 \0001\0"s),
            "deck.toml: saved as UTF-16; save it as UTF-8");
  EXPECT_EQ(mistake("a = 1\nb = \"\xb5m\"\n"), "deck.toml:2:6: the byte \\xb5 is not UTF-8; save the file as UTF-8");
  EXPECT_EQ(mistake("ab\0c"s), "deck.toml: expected text, got a binary file, such as a picture");
}

TEST_F(DeckTest, AMissingDeckIsBadUsage) {
  EXPECT_THAT(test::message_of<InputError>([&] { Deck deck(directory.path() / "none.toml"); }),
              HasSubstr("none.toml: no such deck"));
  EXPECT_THAT(test::message_of<InputError>([&] { Deck deck(directory.path()); }),
              HasSubstr("expected a deck, got a directory"));
}

TEST_F(DeckTest, RefusesAKeyWithoutEnd) {
  std::string key = "a";
  for (int step = 0; step < 5000; ++step) key += ".a";
  EXPECT_EQ(
      without_directory(test::message_of<InputError>([&] { static_cast<void>(read("a = 1\n" + key + " = 1\n")); })),
      "deck.toml:2:1: expected a key, got one with more than 4096 dots");
}

TEST_F(DeckTest, ATextThatCannotBeAFileNameIsReportedAsMissing) {
  const std::string name(300, 'a');
  const auto deck = read("file = \"" + name + "\"\n");
  EXPECT_EQ(deck.root().file("file"), "");
  EXPECT_EQ(mistakes(deck), "deck.toml:1:8: file: no such file: " + name);
  EXPECT_EQ(test::message_of<InputError>([&] { const Deck none(name); }), name + ": no such deck");
}

TEST_F(DeckTest, EveryMistakeIsASingleLine) {
  const auto deck = read("number = \"a\\nb\\u001b[2J\"\n");
  EXPECT_THAT(deck.root().number("number"), IsNan());
  EXPECT_EQ(mistakes(deck), "deck.toml:1:10: number: expected a number, got \"a\\u000ab\\u001b[2J\"");
}

TEST_F(DeckTest, LimitsOfQuantitiesHaveTheirUnits) {
  const auto deck = read("box = \"1 km\"\n");
  EXPECT_THAT(deck.root().quantity("box", Dimension::length, {.lower = 1e-6, .upper = 0.5}), IsNan());
  EXPECT_EQ(mistakes(deck), "deck.toml:1:7: box: expected a length from 1 um to 500 mm, got \"1 km\"");
}

TEST_F(DeckTest, AnUnreadCopyHasNoKnownKeys) {
  const auto deck = read("a = 1\nb = 2\n");
  static_cast<void>(deck.root().number("a"));
  EXPECT_EQ(deck.mistakes().size(), 1U);
  const auto copy = deck.unread_copy();
  EXPECT_TRUE(copy.mistakes().empty());
  EXPECT_EQ(copy.root().number("b"), 2.0);
  EXPECT_EQ(mistakes(copy), "deck.toml:1:1: unknown key \"a\", did you mean \"b\"?");
}

}  // namespace
}  // namespace breccia
