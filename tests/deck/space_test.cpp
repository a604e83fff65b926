// Tests of boxes of three dimensions in the deck.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "decks.hpp"
#include "rasters/npy.hpp"
#include "study/filler_sizes.hpp"
#include "study/identity.hpp"

namespace breccia {
namespace {

using testing::AllOf;
using testing::ElementsAre;
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
  EXPECT_EQ(read.dimensions(), 3);
  EXPECT_TRUE(read.is_periodic());
  EXPECT_EQ(read.seed(), 4U);
}

TEST_F(DeckInSpace, HasCubicLattices) {
  const auto read = stage(one_size, R"(method = "regular", lattice = "fcc", repeats = 1)");
  const auto& cubic = *read.packed_by<LatticePacking>();
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
  ASSERT_NE(read.packed_by<ExplicitPacking<3>>(), nullptr);
  const auto& spheres = std::get<std::vector<Sphere>>(read.packed_by<ExplicitPacking<3>>()->particles);
  ASSERT_EQ(spheres.size(), 2U);
  EXPECT_NEAR(spheres[1].centre[2], 0.6e-3, 1e-18);
  EXPECT_NEAR(spheres[1].diameter, 0.4e-3, 1e-18);

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

TEST_F(DeckInSpace, HasGrains) {
  directory.write("sites.csv", "x_mm,y_mm,z_mm,weight_mm2\n0.25,0.25,0.25,0\n0.75,0.7,0.6,0.01\n");
  const auto read = stage(", fraction = 0.9", R"(method = "laguerre", sites = "sites.csv")");
  const auto* grains = read.packed_by<LaguerrePacking<3>>();
  ASSERT_NE(grains, nullptr);
  EXPECT_TRUE(read.is_periodic());
  EXPECT_FALSE(read.has_seed());
  ASSERT_EQ(grains->sites.size(), 2U);
  EXPECT_NEAR(grains->sites[1].position[2], 0.6e-3, 1e-18);
  EXPECT_NEAR(grains->sites[1].weight, 1e-8, 1e-20);
  EXPECT_EQ(stage(one_size, R"(method = "laguerre", film = "5 um", seed = 3)").seed(), 3U);
  directory.write("shares.csv", "x_mm,y_mm,z_mm,film_share\n0.25,0.25,0.25,0.5\n0.75,0.7,0.6,2\n");
  const auto with_shares = stage(", fraction = 0.9", R"(method = "laguerre", sites = "shares.csv")");
  EXPECT_THAT(with_shares.packed_by<LaguerrePacking<3>>()->film_shares, ElementsAre(0.5, 2.0));

  directory.write("flat.csv", "x_mm,y_mm,weight_mm2\n0.25,0.25,0\n");
  EXPECT_THAT(mistakes(", fraction = 0.9", R"(method = "laguerre", sites = "flat.csv")"),
              HasSubstr("called z, such as z_um"));
  directory.write("outside.csv", "x_mm,y_mm,z_mm\n0.25,0.25,1.5\n");
  EXPECT_THAT(mistakes(", fraction = 0.9", R"(method = "laguerre", sites = "outside.csv")"),
              HasSubstr("outside.csv:2"));
}

class DeckStack : public DeckInSpace {
 protected:
  void write(const std::string& name, const std::vector<std::size_t>& extents,
             const std::vector<std::uint16_t>& values) {
    write_npy(directory.path() / name, extents, values);
  }
  [[nodiscard]] static std::string deck_of(std::string_view packing, std::string_view cells = "cells = 2") {
    return test::join(
        "dimensions = 3\n", test::materials,
        fmt::format("[[stages]]\nname = \"a\"\nmatrix = \"binder\"\n{}\npacking = {{ method = \"image\", {}, labels = "
                    "[{{ value = 0, material = \"binder\" }}, {{ value = 7, material = \"hmx\" }}] }}\n",
                    cells, packing),
        test::tests);
  }
};

TEST_F(DeckStack, OfImagesFillsACube) {
  write("stack.npy", {2, 2, 2}, {7, 0, 0, 0, 0, 0, 0, 7});
  const auto stage = directory.study(deck_of(R"(file = "stack.npy", pixel = "2 um", periodic = true)")).stages.at(0);
  ASSERT_NE(stage.packed_by<ImagePacking<3>>(), nullptr);
  EXPECT_TRUE(stage.is_periodic());
  EXPECT_DOUBLE_EQ(stage.side, 4e-6);
  EXPECT_THAT(stage.packed_by<ImagePacking<3>>()->image->labels, ElementsAre(1, 0, 0, 0, 0, 0, 0, 1));
  write("larger.npy", {4, 4, 4}, [] {
    std::vector<std::uint16_t> values(64, 0);
    values.back() = 7;
    return values;
  }());
  EXPECT_EQ(directory.study(deck_of(R"(file = "larger.npy", pixel = "2 um")", "")).stages.at(0).cells, 2);
}

TEST_F(DeckStack, RefusesWhatIsNoCube) {
  write("flat.npy", {2, 2}, {7, 0, 0, 0});
  EXPECT_THAT(directory.mistakes(deck_of(R"(file = "flat.npy", pixel = "2 um")")),
              HasSubstr("packing.file: expected a stack of images in a box of three dimensions, got one of 2 x 2"));
  write("long.npy", {2, 4, 2}, {7, 0, 0, 0, 0, 0, 0, 7, 7, 0, 0, 0, 0, 0, 0, 7});
  EXPECT_THAT(
      directory.mistakes(deck_of(R"(file = "long.npy", pixel = "2 um")")),
      HasSubstr("expected a cube of voxels, since boxes are cubic, got 2 x 4 x 2 voxels; crop = { left = 0, top = "
                "0, lowest = 0, width = 2, height = 2, depth = 2 } takes a cube of it"));
  write("stack.npy", {2, 2, 2}, {7, 0, 0, 0, 0, 0, 0, 7});
  EXPECT_THAT(directory.mistakes(deck_of(R"(file = "stack.npy", pixel = "2 um", page = 1)")),
              HasSubstr("packing.page: a box of three dimensions takes the whole stack"));
  write("odd.npy", {3, 3, 3}, [] {
    std::vector<std::uint16_t> values(27, 0);
    values.back() = 7;
    return values;
  }());
  EXPECT_THAT(
      directory.mistakes(deck_of(R"(file = "odd.npy", pixel = "2 um")", "")),
      HasSubstr("cells of 2 x 2 x 2 points cannot give each of 3 x 3 x 3 voxels one point; cells = 3 gives each "
                "eight points"));
  EXPECT_THAT(directory.mistakes(deck_of(R"(file = "missing.npy", pixel = "2 um")")), HasSubstr("missing.npy"));
}

constexpr auto spheroid = "x_mm,y_mm,z_mm,axis_1_mm,axis_2_mm,axis_3_mm,azimuth_deg,elevation_deg,roll_deg\n";

TEST_F(DeckInSpace, HasEllipsoidsOfAList) {
  directory.write("ellipsoids.csv", fmt::format("{}0.5,0.4,0.3,0.4,0.3,0.2,90,0,0\n", spheroid));
  const auto read = stage("", R"(method = "explicit", particles = "ellipsoids.csv")");
  const auto& ellipsoids = std::get<std::vector<Ellipsoid>>(read.packed_by<ExplicitPacking<3>>()->particles);
  ASSERT_EQ(ellipsoids.size(), 1U);
  const auto& [centre, axes, directions] = ellipsoids[0];
  EXPECT_NEAR(centre[2], 0.3e-3, 1e-18);
  EXPECT_NEAR(axes[2], 0.2e-3, 1e-18);
  EXPECT_NEAR(directions[0][1], 1.0, 1e-15) << "the first axis along y";
  EXPECT_NEAR(directions[2][2], 1.0, 1e-15);

  const auto refusal = [&](const std::string& rows) {
    directory.write("bad.csv", rows);
    return mistakes("", R"(method = "explicit", particles = "bad.csv")");
  };
  EXPECT_THAT(refusal("x_mm,y_mm,z_mm,axis_1_mm,axis_2_mm\n0.5,0.4,0.3,0.4,0.3\n"), HasSubstr("called axis_3"));
  EXPECT_THAT(refusal(fmt::format("{}0.5,0.4,0.3,0.4,0,0.2,90,0,0\n0.5,0.4,1.3,0.4,0.3,0.2,90,0,0\n", spheroid)),
              AllOf(HasSubstr("bad.csv:2: expected positive axes, got 0.4, 0 and 0.2"),
                    HasSubstr("bad.csv:3: expected a centre in the box, 0 to 1 mm, got (500 um, 400 um, 1.3 mm)")));
  EXPECT_THAT(refusal(fmt::format("{}0.1,0.4,0.3,0.4,0.3,0.2,0,0,0\n", spheroid)), HasSubstr("crosses a wall by"));
  EXPECT_THAT(refusal("x_mm,y_mm,z_mm,diameter_mm,axis_1_mm\n0.5,0.4,0.3,0.4,0.3\n"),
              HasSubstr("expected either diameters, or axis_1"));
}

TEST_F(DeckInSpace, HasEllipsoidsAtRandom) {
  constexpr auto method = R"(method = "random-sequential", walls = false, seed = 5)";
  const auto read = stage(R"(, fraction = 0.2, sizes = { diameter = "0.2 mm" }, shape = { aspect = 2 })", method);
  ASSERT_TRUE(read.fillers[0].shape.has_value());
  EXPECT_EQ(std::get<EllipticOutline>(read.fillers[0].shape->outline).aspect, 2.0);
  EXPECT_EQ(read.seed(), 5U);
  const auto refusal = [&](std::string_view shape, std::string_view packing) {
    return mistakes(fmt::format(R"(, fraction = 0.2, sizes = {{ diameter = "0.2 mm" }}, shape = {})", shape), packing);
  };
  EXPECT_THAT(refusal(R"({ aspect = 2, angle = "3 deg" })", method), HasSubstr("ellipsoids are turned at random"));
  EXPECT_THAT(refusal(R"({ polygon = "p.csv" })", method), HasSubstr("particles of three dimensions are ellipsoids"));
  EXPECT_THAT(refusal("{ aspect = 0 }", method), HasSubstr("shape.aspect"));
  EXPECT_THAT(refusal("\"long\"", method), HasSubstr("expected { aspect = 1.5 } for ellipsoids of revolution"));
  EXPECT_THAT(refusal("{ aspect = 2 }", R"(method = "lubachevsky-stillinger")"),
              HasSubstr("\"lubachevsky-stillinger\" packs spheres alone"));
}

TEST_F(DeckInSpace, PointsFromAPictureOfParticlesToImages) {
  directory.write("stack.TIFF", "pixels");
  EXPECT_THAT(mistakes("", R"(method = "explicit", particles = "stack.TIFF")"),
              AllOf(HasSubstr("stages.a.packing.particles: expected a CSV file with columns x_m, y_m, z_m, diameter_m"),
                    HasSubstr("stack.TIFF; an image is a packing without a filler")));
}

TEST_F(DeckInSpace, RefusesWhatIsFlat) {
  EXPECT_THAT(mistakes(one_size, R"(method = "hexagons")"),
              AllOf(HasSubstr("\"lubachevsky-stillinger\""), HasSubstr("\"random-sequential\"")));
}

TEST_F(DeckInSpace, HasBothMethods) {
  const auto study = directory.study(deck(one_size, R"(method = "regular", lattice = "sc")",
                                          "method = [\"quasistatic\", \"dynamic\"]\nfields = [\"1 ms\"]\n"));
  EXPECT_EQ(study.tests.methods, (std::vector{Method::quasistatic, Method::dynamic}));
  EXPECT_THAT(mistakes(one_size, R"(method = "regular", lattice = "sc")",
                       "method = \"dynamic\"\nfields = [\"1 ms\", \"1 us\"]\n[tests.dynamic]\ncourant = 2\n"),
              AllOf(HasSubstr("fields: expected rising times"), HasSubstr("courant")));
}

TEST_F(DeckInSpace, HasLoadsOfItsOwn) {
  constexpr auto loads = "loads = [\"shear-yz\", \"shear-zx\", \"shear-yy-zz\"]\n";
  const auto study = directory.study(deck(one_size, R"(method = "regular", lattice = "sc")", loads));
  EXPECT_EQ(study.tests.loads, (std::vector<TestLoad>{Load::shear_yz, Load::shear_zx, Load::diagonal_shear_yz}));
  const auto flat = directory.mistakes(test::join(test::materials, test::stage, test::tests, loads));
  EXPECT_THAT(flat, AllOf(HasSubstr("tests.loads: the load \"shear-yz\" is one of three dimensions; a box of two has "
                                    "\"isotropic\", \"shear\", \"shear-xx-yy\", \"bulk\""),
                          HasSubstr("\"shear-yy-zz\"")));
  EXPECT_EQ(std::ranges::count(flat, '\n'), 2) << "each load once: " << flat;
}

// A file with z coordinates lists the centres of discs only if all of them lie in one plane.
TEST_F(DeckInSpace, PlacesInSpaceAreNoneOfASquare) {
  directory.write("spheres.csv", "x_mm,y_mm,z_mm,diameter_mm\n0.25,0.25,0.25,0.3\n0.75,0.7,0.6,0.4\n");
  directory.write("discs.csv", "x_mm,y_mm,z_mm,diameter_mm\n0.25,0.25,0,0.3\n0.75,0.7,0,0.4\n");
  directory.write("sites.csv", "x_mm,y_mm,z_mm\n0.25,0.25,0.25\n0.75,0.7,0.6\n");
  const auto in_a_square = [](std::string_view filler, std::string_view packing) {
    return test::join(test::materials,
                      fmt::format("[[stages]]\nname = \"a\"\nmatrix = \"binder\"\nbox = \"1 mm\"\ncells = 12\n"
                                  "filler = {{ material = \"hmx\"{} }}\npacking = {{ {} }}\n",
                                  filler, packing),
                      test::tests);
  };
  EXPECT_THAT(directory.mistakes(in_a_square("", R"(method = "explicit", particles = "spheres.csv")")),
              AllOf(HasSubstr("packing.particles"), HasSubstr("differ along z"), HasSubstr("dimensions = 3")));
  EXPECT_THAT(directory.mistakes(in_a_square("", R"(method = "laguerre", sites = "sites.csv", film = "10 um")")),
              AllOf(HasSubstr("packing.sites"), HasSubstr("differ along z")));
  const auto study = directory.study(in_a_square("", R"(method = "explicit", particles = "discs.csv")"));
  EXPECT_EQ(study.stages.at(0).packed_by<ExplicitPacking<2>>()->count(), 2U);
}

// A distribution by volume is one by area, cut at the same diameters, so that each class of sizes has its share.
TEST_F(DeckInSpace, SizesAndFractionAreThoseOfTheSection) {
  constexpr auto filler =
      R"(, fraction = 0.3, from = "50 um", to = "0.2 mm", gap = "10 um", sizes = { lognormal = [{ median = "0.1 mm", sigma = 0.5 }] })";
  constexpr auto packing = R"(method = "lubachevsky-stillinger", walls = false)";
  const auto text = deck(filler, packing);
  const auto in_space = directory.study(text).stages.at(0);
  const auto in_the_plane = directory.study("dimensions = 2" + text.substr(text.find('\n'))).stages.at(0);
  EXPECT_EQ(in_the_plane.dimensions(), 2);
  for (const auto& stage : {in_space, in_the_plane}) {
    const auto& one = stage.fillers.at(0);
    EXPECT_EQ(one.fraction, 0.3);
    EXPECT_EQ(one.gap, 10e-6);
    EXPECT_NEAR(distribution_of(one)->cumulative(0.1e-3), distribution_of(in_space.fillers[0])->cumulative(0.1e-3),
                1e-15);
  }
}

TEST_F(DeckInSpace, LatticesAreForThreeDimensions) {
  const auto flat = directory.mistakes(
      test::join(test::materials, "[[stages]]\nname = \"a\"\nmatrix = \"binder\"\nbox = \"1 mm\"\ncells = 12\n",
                 "filler = { material = \"hmx\", sizes = { diameter = \"0.4 mm\" } }\n",
                 "packing = { method = \"regular\", lattice = \"sc\" }\n", test::tests));
  EXPECT_THAT(flat, AllOf(HasSubstr("packing.lattice"), HasSubstr("dimensions = 3"), HasSubstr("columns = 2, rows = 2"),
                          testing::Not(HasSubstr("missing"))));
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
