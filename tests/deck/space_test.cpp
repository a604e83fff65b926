// Boxes of three dimensions in the deck.

#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/study/identity.hpp"

#include "decks.hpp"

namespace breccia {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// A deck with one stage of a cube of 1 mm.
std::string deck(std::string_view filler, std::string_view packing, std::string_view more_tests = "") {
  return test::join("dimensions = 3\n", test::materials,
                    fmt::format("[[stages]]\nname = \"a\"\nmatrix = \"binder\"\nbox = \"1 mm\"\ncells = 12\n"
                                "filler = {{ material = \"hmx\"{} }}\npacking = {{ {} }}\n",
                                filler, packing),
                    test::tests, more_tests);
}

class DeckInSpace : public testing::Test {
 protected:
  [[nodiscard]] Stage stage(std::string_view filler, std::string_view packing) const {
    return directory.study(deck(filler, packing)).stages.at(0);
  }
  [[nodiscard]] std::string mistakes(std::string_view filler, std::string_view packing,
                                     std::string_view more_tests = "") const {
    return directory.mistakes(deck(filler, packing, more_tests));
  }

  test::DeckDirectory directory;
};

constexpr auto one_size = R"(, sizes = { diameter = "0.4 mm" })";

TEST_F(DeckInSpace, HasSpheresPackedAtRandom) {
  const auto read = stage(R"(, fraction = 0.3, gap = "10 um", sizes = { diameter = "0.2 mm" })",
                          R"(method = "lubachevsky-stillinger", walls = false, seed = 4)");
  EXPECT_EQ(read.dimensions, 3);
  EXPECT_TRUE(read.is_periodic());
  EXPECT_EQ(read.seed(), 4U);
}

TEST_F(DeckInSpace, HasCubicLattices) {
  const auto read = stage(one_size, R"(method = "regular", lattice = "fcc", repeats = 1)");
  const auto& cubic = std::get<LatticePacking>(read.packing);
  EXPECT_EQ(cubic.lattice, Lattice::face_centred);
  EXPECT_EQ(cubic.repeats, 1);
  EXPECT_TRUE(read.is_periodic());
  EXPECT_THAT(mistakes(one_size, R"(method = "regular", lattice = "hcp")"),
              AllOf(HasSubstr("packing.lattice"), HasSubstr("\"sc\""), HasSubstr("\"fcc\"")));
  EXPECT_THAT(mistakes(one_size, R"(method = "regular", lattice = "fcc", repeats = 2)"),
              HasSubstr("particles of 400 um touch at a regular spacing of 353.553 um"));
  EXPECT_THAT(mistakes(one_size, R"(method = "regular", columns = 2, rows = 2)"),
              AllOf(HasSubstr("packing.columns"), HasSubstr("lattice = \"sc\", \"bcc\" or \"fcc\"")));
}

TEST_F(DeckInSpace, HasSpheresOfAList) {
  directory.write("spheres.csv", "x_mm,y_mm,z_mm,diameter_mm\n0.25,0.25,0.25,0.3\n0.75,0.7,0.6,0.4\n");
  const auto read = stage("", R"(method = "explicit", particles = "spheres.csv")");
  ASSERT_NE(read.listed(), nullptr);
  ASSERT_EQ(read.listed()->spheres.size(), 2U);
  EXPECT_NEAR(read.listed()->spheres[1].centre[2], 0.6e-3, 1e-18);
  EXPECT_NEAR(read.listed()->spheres[1].diameter, 0.4e-3, 1e-18);

  directory.write("flat.csv", "x_mm,y_mm,diameter_mm\n0.25,0.25,0.3\n");
  EXPECT_THAT(mistakes("", R"(method = "explicit", particles = "flat.csv")"), HasSubstr("called z, such as z_um"));
  directory.write("bad.csv", "x_mm,y_mm,z_mm,diameter_mm\n0.25,0.25,1.25,0.3\n0.5,0.5,0.5,0\n");
  EXPECT_THAT(mistakes("", R"(method = "explicit", particles = "bad.csv")"),
              AllOf(HasSubstr("bad.csv:2: expected a centre in the box, 0 to 1 mm, got (0.25, 0.25, 1.25)"),
                    HasSubstr("bad.csv:3: expected a positive diameter")));
  directory.write("close.csv", "x_mm,y_mm,z_mm,diameter_mm\n0.3,0.3,0.3,0.3\n0.3,0.3,0.5,0.3\n");
  EXPECT_THAT(mistakes("", R"(method = "explicit", particles = "close.csv")"), HasSubstr("overlap"));
  EXPECT_THAT(mistakes("", R"(method = "explicit", particles = "spheres.csv", discs = "spheres.csv")"),
              AllOf(HasSubstr("packing.discs"), HasSubstr("two dimensions")));
}

TEST_F(DeckInSpace, RefusesWhatIsFlat) {
  EXPECT_THAT(mistakes(one_size, R"(method = "laguerre")"), HasSubstr("\"lubachevsky-stillinger\""));
  EXPECT_THAT(mistakes(one_size, R"(method = "regular", lattice = "sc")", "method = \"dynamic\"\n"),
              HasSubstr("three dimensions: expected method \"quasistatic\""));
  EXPECT_THAT(mistakes(one_size, R"(method = "regular", lattice = "sc")",
                       "method = [\"quasistatic\", \"dynamic\"]\nfields = [\"1 ms\"]\n"),
              HasSubstr("three dimensions: expected times of fields with method \"quasistatic\" alone"));
}

TEST_F(DeckInSpace, HasLoadsOfItsOwn) {
  constexpr auto loads = "loads = [\"shear-yz\", \"shear-zx\", \"shear-yy-zz\"]\n";
  const auto study = directory.study(deck(one_size, R"(method = "regular", lattice = "sc")", loads));
  EXPECT_EQ(study.tests.loads, (std::vector{Load::shear_yz, Load::shear_zx, Load::diagonal_shear_yz}));
  EXPECT_THAT(directory.mistakes(test::join(test::materials, test::stage, test::tests, loads)),
              AllOf(HasSubstr("the load \"shear-yz\" is one of three dimensions"), HasSubstr("\"shear-yy-zz\"")));
}

TEST_F(DeckInSpace, LatticesAreForThreeDimensions) {
  const auto flat = directory.mistakes(
      test::join(test::materials, "[[stages]]\nname = \"a\"\nmatrix = \"binder\"\nbox = \"1 mm\"\ncells = 12\n",
                 "filler = { material = \"hmx\", sizes = { diameter = \"0.4 mm\" } }\n",
                 "packing = { method = \"regular\", lattice = \"sc\" }\n", test::tests));
  EXPECT_THAT(flat, AllOf(HasSubstr("packing.lattice"), HasSubstr("dimensions = 3")));
  EXPECT_THAT(directory.mistakes(test::join("dimensions = 4\n", test::materials, test::stage, test::tests)),
              HasSubstr("dimensions"));
}

TEST_F(DeckInSpace, ChangesTheIdentityOfAStudy) {
  const auto text = test::join("dimensions = 2\n", test::materials, test::stage, test::tests);
  const auto flat = directory.study(text), same = directory.study(text.substr(text.find('\n')));
  EXPECT_EQ(content_of(flat), content_of(same)) << "two is the default";
  EXPECT_NE(content_of(directory.study(text, {"dimensions=3"})), content_of(flat));
}

}  // namespace
}  // namespace breccia
