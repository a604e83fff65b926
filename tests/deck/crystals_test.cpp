// Tests of crystals in the deck.

#include <string>
#include <string_view>
#include <variant>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "decks.hpp"

namespace breccia {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr std::string_view cubic = R"(symmetry = "cubic", C11 = "20 GPa", C12 = "14 GPa", C44 = "12 GPa")";

class CrystalsOfADeck : public testing::Test {
 protected:
  [[nodiscard]] static std::string deck(std::string_view stiffness, std::string_view filler = {},
                                        std::string_view tests = "model = \"films\"\n") {
    return test::join(test::materials, "[materials.crystal]\ndensity = \"1.9 g/cm^3\"\nstiffness = { ", stiffness,
                      " }\n[[stages]]\nname = \"a\"\nmatrix = \"binder\"\nbox = \"1 mm\"\n"
                      "filler = { material = \"crystal\", fraction = 0.93, sizes = { diameter = \"0.2 mm\" }",
                      filler, " }\npacking = { method = \"laguerre\", seed = 7 }\n", test::tests, tests);
  }
  [[nodiscard]] Crystal crystal(std::string_view stiffness, std::string_view filler = {}) const {
    return directory.study(deck(stiffness, filler)).stages.at(0).fillers.at(0).crystal.value();
  }
  [[nodiscard]] std::string mistakes(const std::string& text) const { return directory.mistakes(text); }
  [[nodiscard]] static double constant(const Crystal& crystal, std::size_t i, std::size_t j) {
    return crystal.constants[place_of_constant(i, j)];
  }

  test::DeckDirectory directory;
};

TEST_F(CrystalsOfADeck, OfCubicSymmetry) {
  const auto found = crystal(cubic);
  for (std::size_t i = 1; i <= 3; ++i) {
    EXPECT_EQ(constant(found, i, i), 20e9);
    EXPECT_EQ(constant(found, i + 3, i + 3), 12e9);
    EXPECT_EQ(constant(found, i, i % 3 + 1), 14e9);
    EXPECT_EQ(constant(found, i, 4), 0.0);
  }
  EXPECT_TRUE(std::holds_alternative<RandomOrientations>(found.orientations));
  const auto material = directory.study(deck(cubic)).stages.at(0).fillers.at(0).material;
  EXPECT_NEAR(material.bulk.unrelaxed(), 16e9, 1.0);
  EXPECT_NEAR(material.shear.unrelaxed(), 0.5 * (8.4e9 + 60e9 / 11.0), 1.0);
}

TEST_F(CrystalsOfADeck, OfTrigonalSymmetry) {
  const auto found = crystal(R"(symmetry = "trigonal", C11 = "87 GPa", C12 = "7 GPa", C13 = "12 GPa", )"
                             R"(C14 = "-18 GPa", C33 = "107 GPa", C44 = "58 GPa")");
  EXPECT_EQ(constant(found, 6, 6), 40e9);
  EXPECT_EQ(constant(found, 2, 4), 18e9);
  EXPECT_EQ(constant(found, 5, 6), -18e9);
  EXPECT_EQ(constant(found, 2, 2), 87e9);
  EXPECT_EQ(constant(found, 2, 3), 12e9);
}

TEST_F(CrystalsOfADeck, HaveOrientations) {
  EXPECT_TRUE(
      std::holds_alternative<AlignedOrientations>(crystal(cubic, R"(, orientations = "aligned")").orientations));
  const auto seeded = crystal(cubic, ", orientations = { seed = 5 }").orientations;
  EXPECT_EQ(std::get<RandomOrientations>(seeded).seed, 5U);
  directory.write("angles.csv", "phi1_deg,phi_deg,phi2_deg\n0,90,180\n10,20,30\n");
  const auto listed = std::get<ListedOrientations>(crystal(cubic, R"(, orientations = "angles.csv")").orientations);
  ASSERT_EQ(listed.angles.size(), 2U);
  EXPECT_NEAR(listed.angles[0].phi, 1.5707963267948966, 1e-15);
}

TEST_F(CrystalsOfADeck, MistakesAreNamed) {
  EXPECT_THAT(mistakes(deck(R"(symmetry = "cubik", C11 = "1 GPa")")),
              HasSubstr(R"(expected one of "cubic", "hexagonal", "trigonal", "tetragonal", "orthorhombic", )"
                        R"("monoclinic", "triclinic", got "cubik", did you mean "cubic"?)"));
  EXPECT_THAT(mistakes(deck(R"(symmetry = "cubic", C11 = "20 GPa", C12 = "14 GPa")")), HasSubstr("C44: missing"));
  EXPECT_THAT(mistakes(deck(test::join(cubic, R"(, C33 = "1 GPa")"))), HasSubstr("unknown key \"C33\""));
  EXPECT_THAT(mistakes(deck(R"(symmetry = "cubic", C11 = "10 GPa", C12 = "14 GPa", C44 = "12 GPa")")),
              HasSubstr("stiffness: expected a positive definite stiffness"));
  EXPECT_THAT(mistakes(deck(cubic, R"(, orientations = "none.csv")")), HasSubstr("none.csv"));
  directory.write("backwards.csv", "particle,phi1_deg,phi_deg,phi2_deg\n1,0,0,0\n0,0,0,0\n");
  EXPECT_THAT(mistakes(deck(cubic, R"(, orientations = "backwards.csv")")),
              HasSubstr("expected particles in rising order"));
  directory.write("other.csv", "filler,phi1_deg,phi_deg,phi2_deg\n1,0,0,0\n");
  EXPECT_THAT(mistakes(deck(cubic, R"(, orientations = "other.csv")")), HasSubstr("no row of filler 0"));
  EXPECT_THAT(mistakes(deck(R"(C11 = "1 GPa")")), HasSubstr("symmetry: missing; expected one of \"cubic\", "));
  EXPECT_THAT(mistakes(deck(R"(C11 = "1 GPa")", R"(, orientations = "random")")),
              Not(HasSubstr("only crystals have them")));
  EXPECT_THAT(mistakes(deck(cubic, R"(, orientations = "alinged")")), HasSubstr("did you mean \"aligned\"?"));
  EXPECT_THAT(mistakes(deck(R"(symmetry = "cubik", C11 = "1 GPa")")), Not(HasSubstr("voids")));
  EXPECT_THAT(mistakes(deck(test::join(cubic, " }\nbulk = \"1 GPa\"\nextra = { x = 1"))),
              HasSubstr("bulk: the stiffness of a crystal gives all of its moduli"));
}

TEST_F(CrystalsOfADeck, AreFillersAlone) {
  auto text = deck(cubic);
  text.replace(text.find("matrix = \"binder\""), 17, "matrix = \"crystal\"");
  EXPECT_THAT(mistakes(text), HasSubstr("matrix: a crystal, which has a stiffness, is expected as a filler alone"));
  auto isotropic = deck(cubic, R"(, orientations = "random")");
  isotropic.replace(isotropic.find("material = \"crystal\""), 20, "material = \"hmx\"");
  EXPECT_THAT(mistakes(isotropic), HasSubstr("orientations: only crystals have them, whose material has a stiffness"));
}

}  // namespace
}  // namespace breccia
