#include "deckfile/deck_text_edit.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "messages.hpp"

namespace breccia {
namespace {

using testing::HasSubstr;

/// The text of a deck with a value at a path.
std::string with(const std::string& text, const DeckPath& path, const std::string& value) {
  return deck_with_value(text, path, value);
}

std::string refusal(const std::string& text, const DeckPath& path, const std::string& value) {
  return test::message_of<InputError>([&] { deck_with_value(text, path, value); });
}

constexpr auto deck = R"(# A deck.
title = "one"   # its title

# The binder.
[materials.binder]
density = "1.0 g/cm^3"  # by # "hand"
bulk    = "1 MPa"

[[stages]]
name   = "first"
filler = { material = "glass", sizes = { diameter = "2 mm" } }

[tests]
times = ["1 s", "2 s"]
)";

TEST(DeckTextEdit, AValueIsReplacedInItsPlace) {
  EXPECT_EQ(with(deck, {"title"}, "\"two\""), test::replaced(deck, "\"one\"", "\"two\""));
  EXPECT_EQ(with(deck, {"materials", "binder", "density"}, "\"2 # g/cm^3\""),
            test::replaced(deck, "\"1.0 g/cm^3\"", "\"2 # g/cm^3\""));
  EXPECT_EQ(with(deck, {"stages", 0U, "filler", "sizes", "diameter"}, "\"3 mm\""),
            test::replaced(deck, "\"2 mm\"", "\"3 mm\""));
  EXPECT_EQ(with(deck, {"tests", "times", 1U}, "\"4 s\""), test::replaced(deck, "\"2 s\"", "\"4 s\""));
  EXPECT_EQ(with(deck, {"materials", "binder", "bulk"}, "{ value = \"1 MPa\", sd = \"2 kPa\" }"),
            test::replaced(deck, "\"1 MPa\"", "{ value = \"1 MPa\", sd = \"2 kPa\" }"));
  EXPECT_EQ(with(deck, {"stages", 0U, "filler"}, "5"),
            test::replaced(deck, "{ material = \"glass\", sizes = { diameter = \"2 mm\" } }", "5"));
}

TEST(DeckTextEdit, BlanksAroundAValueAreNoPartOfIt) {
  EXPECT_EQ(with("a = 1\n", {"a"}, " \t2\r\n"), "a = 2\n");
}

TEST(DeckTextEdit, ValuesOfEveryFormAreFound) {
  constexpr auto text = R"(a = """
x = 1 # no comment
["""""
b = '''it's ] = #'''  # yes
c = [ # first
  1, # one ]
  [2, 3],
]
d = 1979-05-27 07:32:00 # a day
e = 'a\'
"f.g" = "\"]#\\"
h."i j".'k' = +1_000
l = inf)";
  EXPECT_EQ(with(text, {"a"}, "0"), test::replaced(text, "\"\"\"\nx = 1 # no comment\n[\"\"\"\"\"", "0"));
  EXPECT_EQ(with(text, {"b"}, "0"), test::replaced(text, "'''it's ] = #'''", "0"));
  EXPECT_EQ(with(text, {"c", 0U}, "9"), test::replaced(text, "  1,", "  9,"));
  EXPECT_EQ(with(text, {"c", 1U, 1U}, "9"), test::replaced(text, "[2, 3]", "[2, 9]"));
  EXPECT_EQ(with(text, {"d"}, "0"), test::replaced(text, "1979-05-27 07:32:00", "0"));
  EXPECT_EQ(with(text, {"e"}, "0"), test::replaced(text, R"('a\')", "0"));
  EXPECT_EQ(with(text, {"f.g"}, "0"), test::replaced(text, R"("\"]#\\")", "0"));
  EXPECT_EQ(with(text, {"h", "i j", "k"}, "0"), test::replaced(text, "+1_000", "0"));
  EXPECT_EQ(with(text, {"l"}, "0"), test::replaced(text, "inf", "0"));
}

TEST(DeckTextEdit, KeysInQuotesAreReadAsTheParserReadsThem) {
  EXPECT_EQ(with("\"a\\u00e9\\n\" = 1\n", {"a\u00e9\n"}, "2"), "\"a\\u00e9\\n\" = 2\n");
  EXPECT_EQ(with("[m.\"type 2.1\"]\nx = 1\n", {"m", "type 2.1", "x"}, "2"), "[m.\"type 2.1\"]\nx = 2\n");
  EXPECT_EQ(with("['a]b'] # ]\nx = 1\n", {"a]b", "x"}, "2"), "['a]b'] # ]\nx = 2\n");
}

TEST(DeckTextEdit, LinesOfWindowsAndTextsInUtf8StayAsTheyAre) {
  EXPECT_EQ(with("\xef\xbb\xbf"
                 "a = \"µm\" # ü\r\n\r\n[t]\r\nb = 1\r\n",
                 {"a"}, "\"Å\""),
            "\xef\xbb\xbf"
            "a = \"Å\" # ü\r\n\r\n[t]\r\nb = 1\r\n");
  EXPECT_EQ(with("\xef\xbb\xbf"
                 "[t]\r\nb = 1\r\n",
                 {"a"}, "2"),
            "\xef\xbb\xbf"
            "a = 2\r\n\r\n[t]\r\nb = 1\r\n");
  EXPECT_EQ(with("[t]\r\nb = \"µ\"\r\n", {"t", "c"}, "2"), "[t]\r\nb = \"µ\"\r\nc = 2\r\n");
}

TEST(DeckTextEdit, AMissingKeyIsAddedAfterTheLastOfItsTable) {
  EXPECT_EQ(with("[a]\nx = 1 # one\n\n# of b\n[b]\ny = 2\n", {"a", "z"}, "3"),
            "[a]\nx = 1 # one\nz = 3\n\n# of b\n[b]\ny = 2\n");
  EXPECT_EQ(with("[a]\n  x = [\n1]\n[a.s]\ny = 2\n", {"a", "z"}, "3"), "[a]\n  x = [\n1]\n  z = 3\n[a.s]\ny = 2\n");
  EXPECT_EQ(with("[a] # empty\n\n[b]\n", {"a", "z"}, "3"), "[a] # empty\nz = 3\n\n[b]\n");
  EXPECT_EQ(with("[[s]]\nx = 1\n[[s]]\nx = 2\n", {"s", 0U, "y"}, "3"), "[[s]]\nx = 1\ny = 3\n[[s]]\nx = 2\n");
  EXPECT_EQ(with("[a]\nx = 1\n", {"a", "type 2.1"}, "3"), "[a]\nx = 1\n\"type 2.1\" = 3\n");
}

TEST(DeckTextEdit, AnAddedKeyIsAlignedWhereItsNeighboursAre) {
  EXPECT_EQ(with("[a]\ndensity = 1\nbulk    = 2\n", {"a", "shear"}, "3"),
            "[a]\ndensity = 1\nbulk    = 2\nshear   = 3\n");
  EXPECT_EQ(with("[a]\ndensity = 1\nbulk = 2\n", {"a", "shear"}, "3"), "[a]\ndensity = 1\nbulk = 2\nshear = 3\n");
  EXPECT_EQ(with("[a]\nx = 1\ny = 2\n", {"a", "density"}, "3"), "[a]\nx = 1\ny = 2\ndensity = 3\n");
  EXPECT_EQ(with("[a]\ndensity = 1\n# its bulk modulus\nbulk    = 2\n\nz = 1\n", {"a", "y"}, "3"),
            "[a]\ndensity = 1\n# its bulk modulus\nbulk    = 2\n\nz = 1\ny = 3\n");
  EXPECT_EQ(with("[a]\n\"µm\"   = 1\n", {"a", "x"}, "3"), "[a]\n\"µm\"   = 1\nx      = 3\n");
}

TEST(DeckTextEdit, AMissingKeyOfTheRootIsAddedBeforeTheFirstHeader) {
  EXPECT_EQ(with("# A deck.\n\n# of a\n[a]\n", {"x"}, "1"), "# A deck.\n\nx = 1\n\n# of a\n[a]\n");
  EXPECT_EQ(with("[a]\n", {"x"}, "1"), "x = 1\n\n[a]\n");
  EXPECT_EQ(with("y = 2 # two\n# of a\n[a]\n", {"x"}, "1"), "y = 2 # two\nx = 1\n# of a\n[a]\n");
  EXPECT_EQ(with("", {"x"}, "1"), "x = 1\n");
  EXPECT_EQ(with("# only this", {"x"}, "1"), "# only this\nx = 1");
  EXPECT_EQ(with("y = 2", {"x"}, "1"), "y = 2\nx = 1");
  EXPECT_EQ(with("y = 2\r\nz = 1", {"x"}, "1"), "y = 2\r\nz = 1\r\nx = 1");
}

TEST(DeckTextEdit, AnEntryIsAddedInBraces) {
  EXPECT_EQ(with("a = { x = 1 } # c\n", {"a", "y"}, "2"), "a = { x = 1, y = 2 } # c\n");
  EXPECT_EQ(with("a = {x=1}\n", {"a", "y"}, "2"), "a = {x=1, y = 2}\n");
  EXPECT_EQ(with("a = {}\n", {"a", "y"}, "2"), "a = { y = 2 }\n");
  EXPECT_EQ(with("a = { } # {}\n", {"a", "y"}, "{}"), "a = { y = {} } # {}\n");
  EXPECT_EQ(with("a = { x = [\n  1, # one }\n] }\n", {"a", "y"}, "2"), "a = { x = [\n  1, # one }\n], y = 2 }\n");
  EXPECT_EQ(with("a = { x = 1 }\n", {"a", "y"}, "[\n  1,\n  2\n]"), "a = { x = 1, y = [\n  1,\n  2\n] }\n");
  EXPECT_EQ(with("a = { x = 1 }\n", {"a", "y", "z", 0U}, "{ w = 2 }"), "a = { x = 1, y = { z = [{ w = 2 }] } }\n");
  EXPECT_EQ(with("a = { x.y = 1, b = 2 }\n", {"a", "x", "z"}, "3"), "a = { x.y = 1, x.z = 3, b = 2 }\n");
  EXPECT_EQ(with("a = { x = {} }\n", {"a", "x", "z"}, "3"), "a = { x = { z = 3 } }\n");
}

TEST(DeckTextEdit, AnElementIsAddedInBrackets) {
  EXPECT_EQ(with("a = [1, 2]\n", {"a", 2U}, "3"), "a = [1, 2, 3]\n");
  EXPECT_EQ(with("a = [1, 2, ] # c\n", {"a", 2U}, "3"), "a = [1, 2, 3, ] # c\n");
  EXPECT_EQ(with("a = []\n", {"a", 0U}, "{ x = 1 }"), "a = [{ x = 1 }]\n");
  EXPECT_EQ(with("a = [\n  1,\n  2, # two\n]\n", {"a", 2U}, "3"), "a = [\n  1,\n  2, # two\n  3,\n]\n");
  EXPECT_EQ(with("a = [\n  1,\n  2 # two\n]\n", {"a", 2U}, "3"), "a = [\n  1,\n  2, # two\n  3\n]\n");
  EXPECT_EQ(with("a = [\r\n  1 ]\r\n", {"a", 1U}, "3"), "a = [\r\n  1,\r\n  3 ]\r\n");
  EXPECT_EQ(with("a = [\n  1, 2,\n]\n", {"a", 2U}, "3"), "a = [\n  1, 2, 3,\n]\n");
}

TEST(DeckTextEdit, DottedKeysStayDotted) {
  EXPECT_EQ(with("tests.accuracy = 1\nx = 2\n[a]\n", {"tests", "times"}, "3"),
            "tests.accuracy = 1\ntests.times    = 3\nx = 2\n[a]\n");
  EXPECT_EQ(with("tests.accuracy = 1\n", {"tests", "films"}, "{ divisions = 1 }"),
            "tests.accuracy = 1\ntests.films    = { divisions = 1 }\n");
  EXPECT_EQ(with("[a]\nb.c.d = 1\n", {"a", "b", "e"}, "2"), "[a]\nb.c.d = 1\nb.e   = 2\n");
  EXPECT_EQ(with("[f]\na.c = 1\n[f.a.t]\ns = 1\n", {"f", "a", "e"}, "2"), "[f]\na.c = 1\na.e = 2\n[f.a.t]\ns = 1\n");
  EXPECT_EQ(with("a.b = 1\na.c = 2\n", {"a"}, "{ c = 3, d = 4 }"), "a.c = 3\na.d = 4\n");
  EXPECT_EQ(with("a.b = 1\nx = 1\n", {"a"}, "5"), "x = 1\na = 5\n");
  EXPECT_EQ(with("i = { a.b = 1, c = 2 }\n", {"i", "a"}, "5"), "i = { c = 2, a = 5 }\n");
}

TEST(DeckTextEdit, AMissingTableBecomesABlockAfterItsSiblings) {
  EXPECT_EQ(with(deck, {"materials", "steel"}, "{ density = \"7 g/cm^3\", young = \"2 GPa\", shear = { p = \"s\" } }"),
            test::replaced(deck, "[[stages]]",
                           "[materials.steel]\ndensity = \"7 g/cm^3\"\nyoung   = \"2 GPa\"\nshear   = { p = \"s\" }\n\n"
                           "[[stages]]"));
  EXPECT_EQ(with("[m.a]\nx = 1\n# on a\n\n# of s\n[[s]]\n", {"m", "b", "x"}, "2"),
            "[m.a]\nx = 1\n# on a\n\n[m.b]\nx = 2\n\n# of s\n[[s]]\n");
  EXPECT_EQ(with("[m.a]\nx = 1\n# of s\n[[s]]\n", {"m", "b"}, "{}"), "[m.a]\nx = 1\n\n[m.b]\n\n# of s\n[[s]]\n");
  EXPECT_EQ(with("[m.a]\nx = 1\n[m.a.t]\ny = 1\n", {"m", "b"}, "{ x = 2 }"),
            "[m.a]\nx = 1\n[m.a.t]\ny = 1\n\n[m.b]\nx = 2\n");
  EXPECT_EQ(with("x = 1", {"tests"}, "{ a = 1 }"), "x = 1\n\n[tests]\na = 1");
  EXPECT_EQ(with("x = 1\r\n", {"a", "b c", "d"}, "1"), "x = 1\r\n\r\n[a.\"b c\"]\r\nd = 1\r\n");
  EXPECT_EQ(with("[t]\nx = 1\n\n[u]\n", {"t", "v"}, "{ y = 1, z.a = 2, z.b = 3 }"),
            "[t]\nx = 1\n\n[t.v]\ny = 1\nz = { a = 2, b = 3 }\n\n[u]\n");
}

TEST(DeckTextEdit, AMissingTableIsInBracesWhereThoseBesideItAre) {
  EXPECT_EQ(with("[t]\na = { x = 1 }\n[u]\n", {"t", "b"}, "{ y = 2 }"), "[t]\na = { x = 1 }\nb = { y = 2 }\n[u]\n");
  EXPECT_EQ(with("[t]\na = { x = 1 }\n[t.u]\nz = 1\n", {"t", "b"}, "{ y = 2 }"),
            "[t]\na = { x = 1 }\n[t.u]\nz = 1\n\n[t.b]\ny = 2\n");
  EXPECT_EQ(with(deck, {"stages", 0U, "packing", "seed"}, "1"),
            test::replaced(deck, "2 mm\" } }\n", "2 mm\" } }\npacking = { seed = 1 }\n"));
}

TEST(DeckTextEdit, AKeyOfATableWithoutHeaderGivesItOne) {
  EXPECT_EQ(with("x = 1\n\n# of b\n[m.b]\ny = 1\n", {"m", "z"}, "2"), "x = 1\n\n[m]\nz = 2\n\n# of b\n[m.b]\ny = 1\n");
}

TEST(DeckTextEdit, AnElementIsAddedAfterTheLastWithItsBlocks) {
  EXPECT_EQ(with("[[s]]\nn = 1\n[[s.f]]\nx = 1\n[s.p]\ny = 1\n\n[t]\n", {"s", 1U}, "{ n = 2, filler = { x = 2 } }"),
            "[[s]]\nn = 1\n[[s.f]]\nx = 1\n[s.p]\ny = 1\n\n[[s]]\nn      = 2\nfiller = { x = 2 }\n\n[t]\n");
  EXPECT_EQ(with("[[s]]\nn = 1\n[[s.f]]\nx = 1\n[[s]]\nn = 2\n", {"s", 0U, "f", 1U}, "{ x = 2 }"),
            "[[s]]\nn = 1\n[[s.f]]\nx = 1\n\n[[s.f]]\nx = 2\n\n[[s]]\nn = 2\n");
  EXPECT_EQ(with("s = [{ n = 1 }]\n", {"s", 1U}, "{ n = 2 }"), "s = [{ n = 1 }, { n = 2 }]\n");
  EXPECT_EQ(with("[t]\nx = 1\n", {"s", 0U, "n"}, "1"), "[t]\nx = 1\n\n[[s]]\nn = 1\n");
  EXPECT_EQ(with("[t]\nx = 1\n", {"t", "y", 0U}, "1"), "[t]\nx = 1\ny = [1]\n");
}

TEST(DeckTextEdit, ABlockIsReplacedByABlock) {
  EXPECT_EQ(with("# of a\n[a] # head\nx   = 1 # one\ny   = 2\nzzz = 3\n[a.s]\nw = 1\n[b]\n", {"a"},
                 "{ zzz = 3, x = 5, new = 6 }"),
            "# of a\n[a] # head\nx   = 5 # one\nzzz = 3\nnew = 6\n[b]\n");
  EXPECT_EQ(with("[a]\nx = 1\n[b]\n", {"a"}, "{}"), "[a]\n[b]\n");
  EXPECT_EQ(with("[m.a]\nx = 1\n[b]\n", {"m"}, "{}"), "[b]\n\n[m]\n");
  EXPECT_EQ(with("[[s]]\nx = 1 # one\n[[s]]\nx = 2\n[[s]]\nx = 3\n[b]\n", {"s"}, "[{ x = 4 }, { x = 2, y = 5 }]"),
            "[[s]]\nx = 4 # one\n[[s]]\nx = 2\ny = 5\n[b]\n");
  EXPECT_EQ(with("[[s]]\nx = 1\n[[s.f]]\ny = 1\n\n[[s.f]]\ny = 2\n\n[s.p]\nz = 1\n", {"s", 0U, "f"}, "{ y = 3 }"),
            "[[s]]\nx = 1\n[s.f]\ny = 3\n\n[s.p]\nz = 1\n");
  EXPECT_EQ(with("[s.f]\ny = 1\n\n[s.p]\nz = 1\n", {"s", "f"}, "[{ y = 3 }, { y = 4 }]"),
            "[[s.f]]\ny = 3\n\n[[s.f]]\ny = 4\n\n[s.p]\nz = 1\n");
}

TEST(DeckTextEdit, ABlockIsReplacedByAValueInALine) {
  EXPECT_EQ(with("[t]\nx = 1\n\n[t.a]\ny = 1\n\n[u]\n", {"t", "a"}, "5"), "[t]\nx = 1\na = 5\n\n[u]\n");
  EXPECT_EQ(with("x = 1\n\n[[s]]\ny = 1\n\n[[s]]\n", {"s"}, "[]"), "x = 1\ns = []\n");
}

TEST(DeckTextEdit, MistakesNameThePath) {
  EXPECT_EQ(
      refusal(deck, {"materials", "binder", "bulk"}, "3.6 GPa"),
      "materials.binder.bulk: expected a value of TOML, such as 0.5 or \"2 mm\", got 3.6 GPa: Error while parsing "
      "key-value pair: expected a comment or whitespace, saw 'G'");
  for (const auto* value : {"", "  ", "abc", "1\ny = 2", "1 # comment", "1, 2", "{ a = 1,\n b = 2 }", "[1", "\"open",
                            "1\n[tests]", "# comment", "{ a = 1, a = 2 }", "= 1", "\"\xff\"", "“2 mm”"}) {
    EXPECT_THAT(refusal(deck, {"materials", "binder", "bulk"}, value), HasSubstr("materials.binder.bulk: expected a "))
        << value;
  }
  EXPECT_EQ(refusal(deck, {"title", "x"}, "1"), "title is \"one\", no table and no array: it has no \"x\"");
  EXPECT_EQ(refusal(deck, {"title", 0U}, "1"), "title is \"one\", no table and no array: it has no \"0\"");
  EXPECT_EQ(refusal(deck, {"stages", "first"}, "1"), "stages is an array: it has no \"first\"");
  EXPECT_EQ(refusal(deck, {"stages", 2U}, "{}"), "stages has no element 2: the next one is 1");
  EXPECT_EQ(refusal(deck, {"tests", 0U}, "1"), "tests is a table: it has no element 0");
  EXPECT_EQ(refusal(deck, {0U}, "1"), "the deck is a table: it has no element 0");
  EXPECT_EQ(refusal(deck, {"new", 1U}, "1"), "new has no element 1: the next one is 0");
  EXPECT_EQ(refusal(deck, {"stages", 1U}, "5"),
            "stages.1: expected a table, since stages is an array of [[tables]], got 5");
  EXPECT_EQ(refusal(deck, {"stages", 0U}, "5"), "stages.0 is a block: expected a table, got 5");
  EXPECT_THAT(refusal(deck, {"tests", "\xff"}, "5"), HasSubstr("tests.\\xff: expected keys of TOML"));
}

TEST(DeckTextEdit, ATextThatIsNotTomlIsRefused) {
  EXPECT_THAT(refusal("a = 1\nb\n", {"a"}, "2"), HasSubstr("deck:2:"));
  EXPECT_THAT(test::message_of<InputError>([] { deck_without("a = 1\nb\n", DeckPath{"a"}); }), HasSubstr("not TOML"));
}

TEST(DeckTextEdit, APathHasOneToAHundredSteps) {
  EXPECT_EQ(refusal(deck, {}, "1"), "expected a path of 1 to 100 steps, got 0");
  EXPECT_EQ(refusal(deck, DeckPath(101, "a"), "1"), "expected a path of 1 to 100 steps, got 101");
  EXPECT_THAT(with(deck, DeckPath(100, "a"), "1"), HasSubstr("a.a.a]\na = 1\n"));
}

}  // namespace
}  // namespace breccia
