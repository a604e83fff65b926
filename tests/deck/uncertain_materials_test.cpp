// Tests of decks with inputs that are not certain.

#include <cmath>
#include <string>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/deck/deck_assessment.hpp"

#include "deck/material_file.hpp"
#include "decks.hpp"

namespace breccia {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// Discs of hmx in a binder that relaxes, with other text for some keys.
std::string deck_with(const std::string& binder, const std::string& shear_of_hmx,
                      const std::string& mixing = "mixing = \"series\"\n", const std::string& fraction = "0.5") {
  return "[materials.binder]\ndensity = \"1 g/cm^3\"\nbulk = \"3 GPa\"\n"
         "shear = { equilibrium = \"1 MPa\", terms = [{ time = \"1 ms\", modulus = \"500 MPa\" }] }\n" +
         binder + "\n[materials.hmx]\ndensity = \"1.85 g/cm^3\"\nbulk = \"13.4 GPa\"\nshear = " + shear_of_hmx +
         "\n[[stages]]\nname = \"discs\"\nmatrix = \"binder\"\nbox = \"10 mm\"\ncells = 20\n"
         R"(filler = { material = "hmx", fraction = )" +
         fraction +
         ", sizes = { diameter = \"2 mm\" } }\npacking = { method = \"lubachevsky-stillinger\", seed = 1 }\n"
         "[tests]\ntimes = [\"10 us\", \"1 s\"]\nfields = \"none\"\n" +
         mixing;
}

class UncertainDeck : public testing::Test {
 protected:
  [[nodiscard]] Study study(const std::string& text) const { return directory.study(text); }
  [[nodiscard]] DeckAssessment assessment(const std::string& text, const AssessmentOptions& options = {}) const {
    return {directory.written("deck.toml", text), {}, options};
  }
  [[nodiscard]] std::string refusal(const std::string& text) const {
    const auto message = test::message_of<InputError>([&] { static_cast<void>(assessment(text)); });
    return test::replaced(message, directory.path().string() + "/", "");
  }

  test::DeckDirectory directory;
};

TEST_F(UncertainDeck, AStudyTakesMediansAndSaysSo) {
  const auto read = study(deck_with("", R"({ value = "5.8 GPa", sd = "0.6 GPa" })"));
  EXPECT_DOUBLE_EQ(read.materials.at(1).material.shear.equilibrium(), 5.8e9);
  ASSERT_THAT(read.uncertain, SizeIs(1));
  EXPECT_EQ(read.uncertain.front().name, "materials.hmx.shear");
  EXPECT_THAT(read.provenance.warnings.at("discs"),
              ElementsAre(HasSubstr("not certain: materials.hmx.shear; these results are those with their medians")));
}

TEST_F(UncertainDeck, AnElasticMaterialVariesOverItsDistribution) {
  const auto read = study(deck_with("", R"({ value = "5.8 GPa", sd = "0.6 GPa" })"));
  ASSERT_THAT(read.tests.varied, SizeIs(1));
  const auto& varied = read.tests.varied.front();
  EXPECT_EQ(varied.name, "hmx");
  EXPECT_DOUBLE_EQ(varied.shear->least, 3.4e9);
  EXPECT_DOUBLE_EQ(varied.shear->most, 8.2e9);
  EXPECT_FALSE(varied.bulk) << "it is certain";
  EXPECT_EQ(read.tests.quasistatic.sampling.tolerance, 1e-4);
}

TEST_F(UncertainDeck, ABinderVariesOverItsExtremes) {
  const auto read = study(deck_with(
      "factors = { modulus = { value = 1, factor = 1.2 }, times = { value = 1, factor = 3 } }", R"("5.8 GPa")"));
  ASSERT_THAT(read.tests.varied, SizeIs(1));
  const auto& varied = read.tests.varied.front();
  EXPECT_EQ(varied.name, "binder");
  ASSERT_THAT(varied.others, SizeIs(4)) << "two extremes of two factors";
  const auto& softest = varied.others.front();
  EXPECT_NEAR(softest.shear.unrelaxed(), 501e6 / std::pow(1.2, 4), 1.0);
  EXPECT_NEAR(softest.shear.terms().front().relaxation_time, 1e-3 / std::pow(3.0, 4), 1e-12);
}

TEST_F(UncertainDeck, FactorsChangeABinder) {
  const auto read = study(deck_with("factors = { modulus = 2, times = 10 }", R"("5.8 GPa")"));
  const auto& binder = read.materials.front().material;
  EXPECT_DOUBLE_EQ(binder.shear.unrelaxed(), 1002e6);
  EXPECT_DOUBLE_EQ(binder.shear.terms().front().relaxation_time, 1e-2);
  EXPECT_DOUBLE_EQ(binder.bulk.equilibrium(), 3e9);
  EXPECT_THAT(directory.mistakes(deck_with("factors = { moduli = 2 }", R"("5.8 GPa")")),
              HasSubstr(R"(materials.binder.factors: unknown key "moduli", did you mean "modulus"?)"));
  EXPECT_THAT(directory.mistakes(deck_with("factors = { times = 0 }", R"("5.8 GPa")")),
              HasSubstr("materials.binder.factors.times: expected a positive number, got 0"));
  EXPECT_THAT(directory.mistakes(deck_with("", "\"5.8 GPa\"\nfactors = { times = 2 }")),
              HasSubstr("materials.hmx.factors: hmx.times: the material does not relax"));
}

TEST_F(UncertainDeck, FlowThroughGapsStaysWhatItIs) {
  // Its reduced basis holds for the binder alone: the filler takes boxes of its own.
  const auto text =
      deck_with("factors = { modulus = { value = 1, factor = 1.2 } }", R"({ value = "5.8 GPa", sd = "0.6 GPa" })", "");
  const auto read = study(text);
  EXPECT_EQ(read.tests.mixing, Mixing::flow);
  ASSERT_THAT(read.tests.varied, SizeIs(1));
  EXPECT_EQ(read.tests.varied.front().name, "binder");
  EXPECT_THAT(assessment(text).design().change_the_box, ElementsAre(false, true));
}

TEST_F(UncertainDeck, SolvesOneStudyWhereResponsesAnswerEverything) {
  const auto deck = assessment(deck_with("", R"({ value = "5.8 GPa", sd = "0.6 GPa" })"), {.samples = 200});
  ASSERT_THAT(deck.sweep().tasks, SizeIs(1));
  EXPECT_EQ(deck.sweep().tasks.front().name, "");
  EXPECT_THAT(deck.sweep().keys, IsEmpty());
  EXPECT_EQ(deck.design().coordinates.cols(), 200);
}

TEST_F(UncertainDeck, SolvesABoxForEachValueOfAGeometry) {
  const auto deck = assessment(
      deck_with("", R"({ value = "5.8 GPa", sd = "0.6 GPa" })", "mixing = \"series\"\n", "{ value = 0.5, sd = 0.02 }"));
  const auto& sweep = deck.sweep();
  ASSERT_THAT(sweep.tasks, SizeIs(11)) << "that of the medians, and ten boxes";
  EXPECT_EQ(sweep.tasks[0].name, "median");
  EXPECT_EQ(sweep.tasks[10].name, "box-10");
  EXPECT_EQ(sweep.keys.front().path, "stages.discs.filler.fraction");
  EXPECT_DOUBLE_EQ(sweep.tasks[0].study.stages.front().fillers.front().fraction.value(), 0.5);
  const double share =
      normal_share((sweep.tasks[1].study.stages.front().fillers.front().fraction.value() - 0.5) / 0.02);
  EXPECT_NEAR(std::fmod(10.0 * share, 1.0), 0.5, 1e-9) << "in the middle of a tenth";
  EXPECT_THAT(sweep.tasks[1].study.provenance.overrides, SizeIs(1));
  EXPECT_NE(sweep.tasks[1].study.provenance.hash, sweep.tasks[2].study.provenance.hash);
}

TEST_F(UncertainDeck, NamesMayHaveDotsAndSpaces) {
  auto text = deck_with("", R"({ value = "5.8 GPa", sd = "0.6 GPa" })");
  text = test::replaced(text, "[materials.hmx]", R"([materials."type 2.1"])");
  text = test::replaced(text, R"(material = "hmx")", R"(material = "type 2.1")");
  const auto read = study(text);
  EXPECT_EQ(read.uncertain.front().name, R"(materials."type 2.1".shear)");
  ASSERT_THAT(read.tests.varied, SizeIs(1));
  EXPECT_EQ(read.tests.varied.front().name, "type 2.1");
}

TEST_F(UncertainDeck, AGapIsALengthThatChangesTheBox) {
  const auto text = test::replaced(deck_with("", "\"5.8 GPa\""), "sizes = {",
                                   R"(gap = { value = "0.2 mm", sd = "0.02 mm" }, sizes = {)");
  EXPECT_DOUBLE_EQ(study(text).stages.front().fillers.front().gap, 0.2e-3);
  EXPECT_THAT(assessment(text).design().change_the_box, ElementsAre(true));
}

TEST_F(UncertainDeck, AMaterialFileIsCertain) {
  const auto file = directory.written(
      "soft.toml", "density = \"1 g/cm^3\"\nbulk = \"2 GPa\"\nshear = { value = \"1 MPa\", factor = 2 }\n");
  EXPECT_THAT(test::message_of<InputError>([&] { static_cast<void>(read_shifted_material_file(file)); }),
              HasSubstr("shear: expected one value; distributions are for decks"));
}

TEST_F(UncertainDeck, FindsMistakesOfSamplesBeforeAnythingIsSolved) {
  EXPECT_THAT(refusal(deck_with("", R"({ value = "100 MPa", sd = "25 MPa" })")),
              HasSubstr("materials.hmx.shear.sd: expected less than a quarter"))
      << "four deviations below is no modulus";
  const std::string uncertain = R"({ value = "5.8 GPa", sd = "0.6 GPa" })";
  EXPECT_THAT(refusal(deck_with(
                  "", uncertain,
                  "mixing = \"series\"\nquasistatic = { vary = { hmx = { shear = [\"5 GPa\", \"6 GPa\"] } } }\n")),
              HasSubstr("tests.quasistatic.vary does not hold for all of the distribution of hmx"));
  EXPECT_THAT(refusal(deck_with("", uncertain,
                                R"(mixing = { any = ["series", "flow"] })"
                                "\n")),
              HasSubstr("hmx varies with the median of each input, and not with the others"));
  EXPECT_THAT(refusal(deck_with("", "\"5.8 GPa\"") +
                      "[materials.glass]\ndensity = \"2 g/cm^3\"\nbulk = \"40 GPa\"\nshear = " + uncertain + "\n"),
              HasSubstr("materials.glass.shear: no stage has this material"));
}

TEST_F(UncertainDeck, FilesOfAllChoicesBelongToTheDeck) {
  directory.write("a.csv", "relaxation_time_s,modulus_Pa\n1e-3,5e8\n");
  directory.write("b.csv", "relaxation_time_s,modulus_Pa\n1e-2,5e8\n");
  const std::string terms = R"({ equilibrium = "1 MPa", terms = [{ time = "1 ms", modulus = "500 MPa" }] })";
  const auto with = [&](const std::string& files) {
    return test::replaced(deck_with("", "\"5.8 GPa\""), terms,
                          R"({ equilibrium = "1 MPa", prony = { any = [)" + files + "] } }");
  };
  const auto read = study(with(R"("a.csv", "b.csv")"));
  EXPECT_THAT(read.provenance.file_hashes, SizeIs(2)) << "another b.csv is another study";
  EXPECT_THAT(refusal(with(R"("a.csv", "c.csv")")), HasSubstr("no such file"));
}

TEST_F(UncertainDeck, RefusesWhatCannotBeAssessed) {
  EXPECT_THAT(refusal(deck_with("", R"("5.8 GPa")")), HasSubstr("deck.toml: every input is certain"));
  const std::string uncertain = R"({ value = "5.8 GPa", sd = "0.6 GPa" })";
  EXPECT_THAT(
      refusal(deck_with("", uncertain) + "[sweep]\n\"stages.*.packing.seed\" = [1, 2]\n"),
      HasSubstr("deck.toml: sweep: expected none; an input with several values is written { any = [1, 2, 3] }"));
  EXPECT_THAT(refusal(deck_with("", uncertain, "solver = \"stepping\"\n")),
              HasSubstr("an assessment takes the reduced responses of method"));
  EXPECT_THAT(refusal(deck_with("", R"({ value = "5.8 GPa", sd = "2 GPa" })")),
              HasSubstr("materials.hmx.shear.sd: expected less than a quarter"));
  EXPECT_THAT(refusal(deck_with("", R"("5.8 GPa")", "", "{ any = [0.5, 1.5] }")),
              HasSubstr("stages.discs.filler.fraction: expected a number between 0 and 1"))
      << "each choice is read";
}

}  // namespace
}  // namespace breccia
