// Tests of `amount`, the share of a filler in the whole composite.

#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "decks.hpp"
#include "homogenisation/whole_filler.hpp"

namespace breccia {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr std::string_view materials_of_asphalt = R"(
[materials.bitumen]
density = "1040 kg/m^3"
bulk = "2.5 GPa"
shear = "1 MPa"
[materials.limestone]
density = "2670 kg/m^3"
bulk = "35 GPa"
shear = "25 GPa"
)";

// The shares of an asphalt concrete by volume; the rest of 12.09 % is bitumen.
constexpr double fines = 0.0718, sand = 0.2660, stones = 0.4813, air = 0.0600;
constexpr double bitumen = 1.0 - fines - sand - stones - air;

std::string volume(double share) {
  return fmt::format("amount = {{ volume = {:.17g} }}", share);
}

/// An amount by mass of limestone, from its share by volume.
std::string mass(double share) {
  constexpr double density = bitumen * 1040.0 + (fines + sand + stones) * 2670.0;
  return fmt::format("amount = {{ mass = {:.17g} }}", share * 2670.0 / density);
}

class Amounts : public testing::Test {
 protected:
  struct Keys {
    std::string mastic = volume(fines);
    std::string mortar = volume(sand);
    std::string stones = volume(breccia::stones);
    std::string air = volume(breccia::air);
    std::string more = {};  ///< further stages
  };

  /// A chain of mastic, mortar and asphalt whose fillers have these keys beside their materials and sizes.
  [[nodiscard]] static std::string deck(const Keys& keys) {
    constexpr auto packing = "packing = { method = \"random\", seed = 1 }\n";
    const auto filler = [](std::string_view material, std::string_view size, std::string_view more) {
      return test::join("{ material = \"", material, "\", sizes = { diameter = \"", size, "\" }, ", more, " }");
    };
    return test::join(materials_of_asphalt, "[[stages]]\nname = \"mastic\"\nmatrix = \"bitumen\"\nbox = \"0.5 mm\"\n",
                      "cells = 60\nfiller = ", filler("limestone", "0.05 mm", keys.mastic), "\n", packing,
                      "[[stages]]\nname = \"mortar\"\nmatrix = \"mastic\"\nparticles = 100\ncells = 60\nfiller = ",
                      filler("limestone", "1 mm", keys.mortar), "\n", packing,
                      "[[stages]]\nname = \"asphalt\"\nmatrix = \"mortar\"\nbox = \"60 mm\"\ncells = 60\nfiller = [",
                      filler("limestone", "8 mm", keys.stones), ", ", filler("void", "4 mm", keys.air), "]\n", packing,
                      keys.more, test::tests);
  }
  [[nodiscard]] Study study(const Keys& keys, const std::vector<std::string>& overrides = {}) const {
    return directory.study(deck(keys), overrides);
  }
  [[nodiscard]] std::string mistakes(const Keys& keys) const { return directory.mistakes(deck(keys)); }

  test::DeckDirectory directory;
};

double fraction(const Study& study, std::size_t stage, std::size_t filler = 0) {
  return study.stages.at(stage).fillers.at(filler).fraction.value();
}

/// The filler of the whole, as `check` shows it, of boxes that have the fractions that are asked for.
WholeFiller whole(const Study& study) {
  std::vector<std::vector<FillerStatistics>> packed;
  for (const auto& stage : study.stages) {
    packed.emplace_back();
    for (const auto& filler : stage.fillers) packed.back().push_back({.fraction = filler.fraction.value()});
  }
  return filler_of_the_whole(study, study.stages.back(), packed);
}

void expect_asphalt(const Study& study) {
  EXPECT_NEAR(fraction(study, 0), fines / (bitumen + fines), 1e-14);
  EXPECT_NEAR(fraction(study, 1), sand / (bitumen + fines + sand), 1e-14);
  EXPECT_NEAR(fraction(study, 2, 0), stones, 1e-14);
  EXPECT_NEAR(fraction(study, 2, 1), air, 1e-14);
  const auto filler = whole(study);
  constexpr double solid = fines + sand + stones;
  EXPECT_NEAR(filler.fraction, solid, 1e-14);
  EXPECT_NEAR(filler.porosity, air, 1e-14);
  EXPECT_NEAR(filler.mass_fraction, 2670.0 * solid / (2670.0 * solid + 1040.0 * bitumen), 1e-14);
}

TEST_F(Amounts, ByVolumeAreSharesOfTheWhole) {
  expect_asphalt(study({}));
  expect_asphalt(study({.mastic = "amount = { volume = \"7.18 %\" }", .stones = "amount = { volume = \"48.13 %\" }"}));
}

TEST_F(Amounts, ByMassAreSharesOfTheMassOfTheWholeAndVoidsAreByVolume) {
  expect_asphalt(study({.mastic = mass(fines), .mortar = mass(sand), .stones = mass(stones)}));
}

TEST_F(Amounts, TheBinderTakesTheRestWhereOneIsSet) {
  const auto changed = study({}, {"stages.asphalt.filler.0.amount.volume=40 %"});
  constexpr double rest = bitumen + stones - 0.4;
  EXPECT_NEAR(fraction(changed, 0), fines / (rest + fines), 1e-14);
  EXPECT_NEAR(fraction(changed, 1), sand / (rest + fines + sand), 1e-14);
  EXPECT_NEAR(fraction(changed, 2), 0.4, 1e-14);
}

TEST_F(Amounts, AFinerStageIsAnotherOneWhereALaterAmountChanges) {
  const auto first = study({}), changed = study({}, {"stages.asphalt.filler.0.amount.volume=40 %"});
  EXPECT_NE(changed.provenance.stage_hashes.at(0), first.provenance.stage_hashes.at(0));
  // A fraction of a later stage is no matter of this one.
  const Keys fractions = {"fraction = 0.3", "fraction = 0.4", "fraction = 0.4", "fraction = 0.05"};
  EXPECT_EQ(study(fractions, {"stages.asphalt.filler.0.fraction=0.3"}).provenance.stage_hashes.at(0),
            study(fractions).provenance.stage_hashes.at(0));
}

TEST_F(Amounts, MayBeUncertain) {
  const auto uncertain = study({.mastic = "amount = { volume = { value = \"7.18 %\", sd = \"1 %\" } }"});
  expect_asphalt(uncertain);
  ASSERT_EQ(uncertain.uncertain.size(), 1U);
  EXPECT_EQ(uncertain.uncertain[0].name, "stages.mastic.filler.amount.volume");
}

TEST_F(Amounts, OfSeveralFillersShareABox) {
  const auto one = test::join(materials_of_asphalt, R"(
[[stages]]
name = "concrete"
matrix = "bitumen"
box = "60 mm"
cells = 60
filler = [
  { material = "limestone", sizes = { diameter = "8 mm" }, amount = { volume = 0.3 } },
  { material = "limestone", sizes = { diameter = "4 mm" }, amount = { volume = 0.2 } },
]
packing = { method = "random", seed = 1 }
[[stages]]
name = "other"
matrix = "bitumen"
box = "60 mm"
cells = 60
filler = { material = "limestone", sizes = { diameter = "8 mm" }, fraction = 0.25 }
packing = { method = "random", seed = 1 }
)",
                              test::tests);
  const auto read = directory.study(one);
  EXPECT_DOUBLE_EQ(fraction(read, 0, 0), 0.3);
  EXPECT_DOUBLE_EQ(fraction(read, 0, 1), 0.2);
  EXPECT_EQ(fraction(read, 1), 0.25) << "another composite, which needs no amounts";
}

TEST_F(Amounts, OfGrainsStandForTheirFraction) {
  const auto grains = [&](std::string_view keys, std::string_view packing = "") {
    return test::join(materials_of_asphalt, "[[stages]]\nname = \"grains\"\nmatrix = \"bitumen\"\nbox = \"6 mm\"\n",
                      "cells = 60\nfiller = { material = \"limestone\", sizes = { diameter = \"1 mm\" }, ", keys,
                      " }\npacking = { method = \"laguerre\"", packing, " }\n", test::tests);
  };
  // 0.95 by mass: 0.95 / 2670 of volume beside 0.05 / 1040.
  const auto read = directory.study(grains("amount = { mass = \"95 %\" }"));
  EXPECT_NEAR(fraction(read, 0), 0.95 / 2670.0 / (0.95 / 2670.0 + 0.05 / 1040.0), 1e-14);
  EXPECT_THAT(directory.mistakes(grains("amount = { mass = \"95 %\" }", ", film = \"10 um\"")),
              HasSubstr("stages.grains.filler.amount: it follows from packing.film"));
}

TEST_F(Amounts, MistakesOfOne) {
  EXPECT_THAT(mistakes({.mastic = "amount = \"7 %\""}),
              HasSubstr("stages.mastic.filler.amount: expected { mass = \"65 %\" } or { volume = \"65 %\" }"));
  EXPECT_THAT(mistakes({.mastic = "amount = { share = 0.1 }"}),
              HasSubstr("stages.mastic.filler.amount: expected exactly one of mass, volume"));
  EXPECT_THAT(mistakes({.mastic = "amount = { volume = 7.18 }"}),
              HasSubstr("stages.mastic.filler.amount.volume: expected a number between 0 and 1, or per cent"));
  EXPECT_THAT(mistakes({.mastic = test::join(volume(fines), ", fraction = 0.3")}),
              HasSubstr("stages.mastic.filler.fraction: it follows from the amount"));
  EXPECT_THAT(mistakes({.air = "amount = { mass = 0.06 }"}),
              HasSubstr("stages.asphalt.filler.1.amount: a void has no mass: expected { volume = ... }"));
}

TEST_F(Amounts, MistakesOfAWhole) {
  EXPECT_THAT(mistakes({.mortar = "fraction = 0.4", .stones = "fraction = 0.4"}),
              AllOf(HasSubstr("stages.mortar.filler.amount: missing: other fillers of the composite have an amount"),
                    HasSubstr("stages.asphalt.filler.0.amount: missing"), Not(HasSubstr("stages.mastic"))));
  EXPECT_THAT(mistakes({.mortar = mass(sand)}),
              AllOf(HasSubstr("stages.mortar.filler.amount: expected { volume = ... }, as of the fillers before it"),
                    Not(HasSubstr("stages.asphalt"))));
  EXPECT_THAT(mistakes({.stones = volume(0.61)}),
              HasSubstr("stages.asphalt.filler.1.amount: the amounts by volume add up to 100.78 %: expected less than "
                        "100 %, since the binder takes the rest"));
  EXPECT_THAT(mistakes({.mastic = mass(0.3), .mortar = mass(0.3), .stones = mass(0.5)}),
              HasSubstr("stages.asphalt.filler.0.amount: the amounts by mass add up to 126.9"));
  EXPECT_THAT(
      mistakes({.mortar = test::join(volume(sand), R"(, coating = { material = "bitumen", thickness = "9 um" })")}),
      HasSubstr("stages.mortar.filler.coating: the mass and the volume of a coating are not known before"));
}

TEST_F(Amounts, AreRefusedWhereTheWholeIsAmbiguous) {
  const auto second = R"([[stages]]
name = "other"
matrix = "mortar"
box = "60 mm"
cells = 60
filler = { material = "limestone", sizes = { diameter = "8 mm" }, amount = { volume = 0.3 } }
packing = { method = "random", seed = 1 }
)";
  EXPECT_THAT(mistakes({.more = second}),
              HasSubstr("stages.mortar: expected the matrix of one stage at most, or fillers with fraction"));
}

TEST_F(Amounts, AreOfPackedParticles) {
  auto listed = deck({});
  listed = test::replaced(listed, "sizes = { diameter = \"8 mm\" }", "sizes = { list = [\"8 mm\"] }");
  EXPECT_THAT(directory.mistakes(listed),
              HasSubstr("stages.asphalt.filler.0.amount: a list of sizes is packed as it is: its fraction follows"));
}

}  // namespace
}  // namespace breccia
