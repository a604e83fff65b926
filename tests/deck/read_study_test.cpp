#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "decks.hpp"
#include "study/identity.hpp"

namespace breccia {
namespace {

using testing::HasSubstr;

TEST(StudyDeck, ResolvesEverything) {
  const test::DeckDirectory directory;
  const auto study = directory.study(test::join("title = \"A\"\n", test::materials, test::stage, test::tests));
  EXPECT_EQ(study.title, "A");
  EXPECT_EQ(study.provenance.deck, directory.path() / "deck.toml");
  EXPECT_EQ(study.provenance.content, content_of(study));
  EXPECT_THAT(study.provenance.deck_text, HasSubstr("title = \"A\""));
  ASSERT_EQ(study.materials.size(), 2U);
  EXPECT_EQ(study.materials[0].material.name, "binder");
  ASSERT_EQ(study.stages.size(), 1U);
  EXPECT_EQ(std::get<Material>(study.stages[0].matrix), study.materials[0].material);
  EXPECT_DOUBLE_EQ(study.stages[0].cell_size(), 0.16e-6);
  EXPECT_EQ(study.tests.loads, std::vector{TestLoad::isotropic()});
}

TEST(StudyText, IsTheStudyOfADeckWithoutAFile) {
  const test::DeckDirectory directory;
  directory.write("shear.csv", "relaxation_time_s,modulus_Pa\n0.01,5e5\n");
  const auto text = test::replaced(test::join("title = \"A\"\n", test::materials, test::stage, test::tests),
                                   "shear = \"1 MPa\"", "shear = { prony = \"shear.csv\" }");
  const auto of_deck = directory.study(text), of_text = study_from_text(text, directory.path());
  EXPECT_EQ(content_of(of_text), content_of(of_deck));
  EXPECT_EQ(of_text.provenance.hash, of_deck.provenance.hash);
  EXPECT_EQ(of_text.provenance.inputs, std::vector{directory.path() / "shear.csv"});
}

TEST(StudyText, MistakesHaveItsNameInPlaceOfALine) {
  const test::DeckDirectory directory;
  const auto text = test::replaced(test::join(test::materials, test::stage, test::tests), "3.6 GPa", "3.6 um");
  const auto message = test::message_of<InputError>(
      [&] { static_cast<void>(study_from_text("colour = 1\n" + text, directory.path(), {"stages.0.cells=1"})); });
  for (const auto* line :
       {"study: materials.binder.bulk: expected a pressure, got \"3.6 um\"\n", "study: unknown key \"colour\"",
        "\n--set stages.0.cells=1: stages.HB-1.cells: expected an"}) {
    EXPECT_THAT(message, HasSubstr(line));
  }
}

TEST(StudyText, OverridesAreCalledAsTheirOriginSays) {
  const test::DeckDirectory directory;
  const auto message = test::message_of<InputError>([&] {
    static_cast<void>(study_from_text(test::join(test::materials, test::stage, test::tests), directory.path(),
                                      {"stages.0.cells=1"}, {.overrides = "overrides"}));
  });
  EXPECT_THAT(message, HasSubstr("overrides stages.0.cells=1: stages.HB-1.cells: expected an"));
}

TEST(StudyDeck, TheTitleDefaultsToTheNameOfTheDeck) {
  const test::DeckDirectory directory;
  EXPECT_EQ(directory.study(test::join(test::materials, test::stage, test::tests)).title, "deck");
}

TEST(StudyDeck, TheHashDistinguishesDecksAndOverrides) {
  const test::DeckDirectory directory;
  const auto text = test::join(test::materials, test::stage, test::tests);
  const auto hash = directory.study(text).provenance.hash;
  EXPECT_EQ(directory.study(text).provenance.hash, hash);
  EXPECT_NE(directory.study("title = \"A\"\n" + text).provenance.hash, hash);
  EXPECT_NE(directory.study(text, {"stages.0.cells=100"}).provenance.hash, hash);
}

TEST(StudyDeck, TheHashKnowsNoCommentsAndNoSweep) {
  const test::DeckDirectory directory;
  const auto text = test::join(test::materials, test::stage, test::tests);
  EXPECT_EQ(directory.study("# A comment\n" + text + "[sweep]\n\"title\" = [\"A\"]\n").provenance.hash,
            directory.study(text).provenance.hash);
}

TEST(StudyDeck, TheHashDependsOnTheFileOfALine) {
  const test::DeckDirectory directory;
  const auto bulk = test::replaced(test::join(test::materials, test::stage, test::tests), "bulk = \"3.6 GPa\"",
                                   "bulk = { prony = \"a.csv\" }");
  const auto text = test::replaced(bulk, "shear = \"1 MPa\"", "shear = { prony = \"b.csv\" }");
  const std::string table = "relaxation_time_s,modulus_Pa\ninf,1e9\n";
  directory.write("a.csv", table + "# a note\n");
  directory.write("b.csv", table);
  const auto hash = directory.study(text).provenance.hash;
  directory.write("a.csv", table);
  directory.write("b.csv", "# a note\n" + table);
  EXPECT_NE(directory.study(text).provenance.hash, hash);
}

TEST(StudyDeck, HashesOfStagesDependOnTheInputsOfTheirResults) {
  const test::DeckDirectory directory;
  auto second = test::replaced(std::string(test::stage), "name = \"HB-1\"", "name = \"HB-2\"");
  const auto text = test::join(test::materials, test::stage, second, test::tests);
  const auto hashes = directory.study(text).provenance.stage_hashes;
  ASSERT_EQ(hashes.size(), 2U);
  const auto after = [&](const std::string& override_text) {
    return directory.study(text, {override_text}).provenance.stage_hashes;
  };
  EXPECT_EQ(after("title=\"B\""), hashes);
  const auto later = after("stages.HB-2.cells=100");
  EXPECT_EQ(later[0], hashes[0]);
  EXPECT_NE(later[1], hashes[1]);
  for (const auto* override_text :
       {"stages.HB-1.cells=100", "tests.points_per_decade=10", "materials.binder.bulk=4 GPa"}) {
    EXPECT_NE(after(override_text)[0], hashes[0]) << override_text;
    EXPECT_NE(after(override_text)[1], hashes[1]) << override_text;
  }
  EXPECT_NE(after("stages.HB-2.matrix=HB-1")[0], hashes[0]) << "is tested in bulk, too";
  const std::string in_bulk = R"(tests.loads=["shear", "bulk"])";
  EXPECT_NE(directory.study(text, {in_bulk, "stages.HB-2.matrix=HB-1"}).provenance.stage_hashes[0], after(in_bulk)[0])
      << "is fitted";
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
      "deck.toml:6:1: stages.HB/1.cells: missing, expected cells or resolution: they are chosen for a random packing "
      "alone\n"
      "deck.toml:7:8: stages.HB/1.name: expected letters, digits, \"-\", \"_\" and \".\" (it names a directory), "
      "got \"HB/1\"\n"
      "deck.toml:8:10: stages.HB/1.matrix: unknown material or earlier stage \"bindr\", did you mean \"binder\"?\n"
      "deck.toml:10:1: stages.HB/1: unknown key \"cels\", did you mean \"cells\"?\n"
      "deck.toml:12:9: tests.times: expected two rising times, such as [\"10 ns\", \"10 ms\"]");
}

}  // namespace
}  // namespace breccia
