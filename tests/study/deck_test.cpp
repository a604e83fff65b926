#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "decks.hpp"

namespace breccia {
namespace {

using testing::HasSubstr;

TEST(StudyDeck, ResolvesEverything) {
  const test::DeckDirectory directory;
  const auto study = directory.study(test::join("title = \"A\"\n", test::materials, test::stage, test::tests));
  EXPECT_EQ(study.title, "A");
  EXPECT_EQ(study.deck, directory.path() / "deck.toml");
  EXPECT_THAT(study.deck_text, HasSubstr("title = \"A\""));
  ASSERT_EQ(study.materials.size(), 2U);
  EXPECT_EQ(study.materials[0].name, "binder");
  ASSERT_EQ(study.stages.size(), 1U);
  EXPECT_EQ(std::get<Material>(study.stages[0].matrix), study.materials[0]);
  EXPECT_DOUBLE_EQ(study.stages[0].cell_size(), 0.16e-6);
  EXPECT_EQ(study.tests.loads, std::vector{Load::shear});
}

TEST(StudyDeck, TheTitleDefaultsToTheNameOfTheDeck) {
  const test::DeckDirectory directory;
  EXPECT_EQ(directory.study(test::join(test::materials, test::stage, test::tests)).title, "deck");
}

TEST(StudyDeck, TheHashTellsDecksAndOverridesApart) {
  const test::DeckDirectory directory;
  const auto text = test::join(test::materials, test::stage, test::tests);
  const auto hash = directory.study(text).hash;
  EXPECT_EQ(directory.study(text).hash, hash);
  EXPECT_NE(directory.study("title = \"A\"\n" + text).hash, hash);
  EXPECT_NE(directory.study(text, {"stages.0.cells=100"}).hash, hash);
}

TEST(StudyDeck, TheHashKnowsNoCommentsAndNoSweep) {
  const test::DeckDirectory directory;
  const auto text = test::join(test::materials, test::stage, test::tests);
  EXPECT_EQ(directory.study("# A comment\n" + text + "[sweep]\n\"title\" = [\"A\"]\n").hash,
            directory.study(text).hash);
}

TEST(StudyDeck, AnEmptyDeckLacksItsThreeParts) {
  const test::DeckDirectory directory;
  EXPECT_EQ(directory.mistakes(""),
            "deck.toml:1:1: materials: missing, expected a table\n"
            "deck.toml:1:1: stages: missing, expected an array of tables\n"
            "deck.toml:1:1: tests: missing, expected a table");
}

TEST(StudyDeck, ReportsMistakesOfAllPartsAtOnce) {
  const test::DeckDirectory directory;
  const auto mistakes = directory.mistakes(R"(titel = "A"
[materials.binder]
density = "1.48 GPa"
bulk = "3.6 GPa"
shear = { prony = "none.csv" }
[[stages]]
name = "HB/1"
matrix = "bindr"
box = "48 um"
cels = 300
[tests]
times = ["10 ms", "10 ns"]
)");
  EXPECT_EQ(
      mistakes,
      "deck.toml:1:1: unknown key \"titel\", did you mean \"title\"?\n"
      "deck.toml:3:11: materials.binder.density: expected a density, got \"1.48 GPa\"\n"
      "deck.toml:5:19: materials.binder.shear.prony: no such file: none.csv\n"
      "deck.toml:6:1: stages.HB/1: expected exactly one of cells, resolution\n"
      "deck.toml:7:8: stages.HB/1.name: expected letters, digits, \"-\", \"_\" and \".\" (it names a directory), "
      "got \"HB/1\"\n"
      "deck.toml:8:10: stages.HB/1.matrix: unknown material or earlier stage \"bindr\", did you mean \"binder\"?\n"
      "deck.toml:10:1: stages.HB/1: unknown key \"cels\", did you mean \"cells\"?\n"
      "deck.toml:12:9: tests.times: expected two rising times, such as [\"10 ns\", \"10 ms\"]");
}

}  // namespace
}  // namespace breccia
