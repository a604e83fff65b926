// Tests of voids in the deck.

#include <string>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "decks.hpp"

namespace breccia {
namespace {

using testing::HasSubstr;

class VoidsOfADeck : public testing::Test {
 protected:
  /// A deck with a stage that has these lines after its name, matrix and box.
  [[nodiscard]] static std::string deck(std::string_view stage, std::string_view materials = {},
                                        std::string_view tests = {}) {
    return test::join(test::materials, materials,
                      "[[stages]]\nname = \"a\"\nmatrix = \"binder\"\nbox = \"1 mm\"\ncells = 100\n", stage,
                      test::tests, tests);
  }
  [[nodiscard]] static std::string with_filler(std::string_view filler) {
    return deck(test::join("filler = { fraction = 0.3, sizes = { diameter = \"0.2 mm\" }, ", filler,
                           " }\npacking = { method = \"lubachevsky-stillinger\", seed = 1 }\n"));
  }
  [[nodiscard]] std::string mistakes(const std::string& text) const { return directory.mistakes(text); }

  test::DeckDirectory directory;
};

TEST_F(VoidsOfADeck, AreFillers) {
  const auto stage = directory.study(with_filler("material = \"void\"")).stages.at(0);
  EXPECT_EQ(stage.fillers.at(0).material, void_material());
}

TEST_F(VoidsOfADeck, HaveNoMaterialOfTheirOwn) {
  EXPECT_THAT(mistakes(deck("", "[materials.void]\nbulk = \"1 Pa\"\n")),
              HasSubstr("materials.void: a void has no moduli: fillers and labels of pixels name it"));
}

TEST_F(VoidsOfADeck, AreNeitherMatrixNorCoating) {
  auto text = with_filler("material = \"hmx\"");
  text.replace(text.find("matrix = \"binder\""), 17, "matrix = \"void\"");
  EXPECT_THAT(mistakes(text), HasSubstr("stages.a.matrix: expected a solid: only fillers are voids"));
  EXPECT_THAT(mistakes(with_filler("material = \"hmx\", coating = { material = \"void\", thickness = \"10 um\" }")),
              HasSubstr("coating.material: a particle in a void carries nothing: expected a filler of void"));
}

TEST_F(VoidsOfADeck, AreNoGrainsBetweenFilms) {
  EXPECT_THAT(mistakes(deck("filler = { material = \"void\", fraction = 0.9, sizes = { diameter = \"0.1 mm\" } }\n"
                            "packing = { method = \"laguerre\", seed = 7 }\n",
                            "", "model = \"films\"\n")),
              HasSubstr("expected solid grains; with model = \"cells\" they may be voids"));
}

TEST_F(VoidsOfADeck, AreNoStages) {
  auto text = with_filler("material = \"hmx\"");
  text.replace(text.find("name = \"a\""), 10, "name = \"void\"");
  EXPECT_THAT(mistakes(text), HasSubstr("\"void\" is the name of a filler without stiffness"));
}

TEST_F(VoidsOfADeck, DoNotVary) {
  EXPECT_THAT(mistakes(test::join(with_filler("material = \"void\""),
                                  "[tests.quasistatic]\nvary = { void = { shear = [\"1 MPa\", \"1 GPa\"] } }\n")),
              HasSubstr("a void has no moduli that could vary"));
}

TEST_F(VoidsOfADeck, AreWrittenInSmallLetters) {
  EXPECT_THAT(mistakes(with_filler("material = \"Void\"")), HasSubstr("unknown material \"Void\""));
}

}  // namespace
}  // namespace breccia
