#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "decks.hpp"

namespace breccia {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

ParticleList<2> listed_in(const Stage& stage) {
  return stage.packed_by<ExplicitPacking<2>>()->particles;
}

class DeckShapes : public testing::Test {
 protected:
  /// A deck with one stage of 6 mm, a filler with these keys and a packing with those.
  [[nodiscard]] static std::string deck(std::string_view filler_keys, std::string_view packing_keys) {
    return test::join(test::materials, "[[stages]]\nname = \"a\"\nmatrix = \"binder\"\nbox = \"6 mm\"\ncells = 60\n",
                      "filler = { material = \"hmx\"", filler_keys, " }\npacking = { method = ", packing_keys, " }\n",
                      test::tests);
  }
  [[nodiscard]] Stage stage(std::string_view filler_keys, std::string_view packing_keys) const {
    return directory.study(deck(filler_keys, packing_keys)).stages.at(0);
  }
  [[nodiscard]] std::string mistakes(std::string_view filler_keys, std::string_view packing_keys) const {
    return directory.mistakes(deck(filler_keys, packing_keys));
  }
  /// The mistakes of a random packing with this shape.
  [[nodiscard]] std::string mistakes_of_shape(std::string_view shape) const {
    return mistakes(test::join(amount, ", shape = ", shape), sequential);
  }
  /// The mistakes of an explicit packing of a table with these lines.
  [[nodiscard]] std::string mistakes_of_table(std::string_view lines) const {
    directory.write("particles.csv", lines);
    return mistakes("", R"("explicit", particles = "particles.csv")");
  }
  [[nodiscard]] std::string mistakes_of_polygons(std::string_view lines) const {
    directory.write("polygons.csv", lines);
    return mistakes("", R"("explicit", polygons = "polygons.csv")");
  }

  static constexpr auto amount = ", fraction = 0.5, sizes = { diameter = \"0.5 mm\" }";
  static constexpr auto sequential = "\"random-sequential\"";
  test::DeckDirectory directory;
};

TEST_F(DeckShapes, Ellipses) {
  const auto read = stage(test::join(amount, ", shape = { aspect = 1.5, angle = \"30 deg\" }"),
                          "\"random-sequential\", walls = false, seed = 7");
  const auto& packing = *read.packed_by<RandomSequentialPacking<2>>();
  EXPECT_EQ(packing.walls, Walls::periodic);
  EXPECT_EQ(packing.seed, 7U);
  EXPECT_TRUE(read.is_random());
  EXPECT_EQ(read.seed(), 7U);
  const auto& shape = read.fillers.at(0).shape.value();
  EXPECT_EQ(std::get<EllipticOutline>(shape.outline).aspect, 1.5);
  EXPECT_NEAR(shape.angle.value(), std::numbers::pi / 6.0, 1e-15);
  EXPECT_DOUBLE_EQ(read.fillers.at(0).gap, 0.05e-3);
}

TEST_F(DeckShapes, WithoutAngleOrAspectOneOrShape) {
  EXPECT_FALSE(stage(test::join(amount, ", shape = { aspect = 2 }"), sequential).fillers.at(0).shape->angle);
  EXPECT_FALSE(stage(test::join(amount, ", shape = { aspect = 1 }"), sequential).fillers.at(0).shape);
  EXPECT_FALSE(
      stage(test::join(amount, ", shape = { aspect = 1.0 }"), "\"lubachevsky-stillinger\"").fillers.at(0).shape);
  EXPECT_FALSE(stage(amount, sequential).fillers.at(0).shape);
}

TEST_F(DeckShapes, Polygons) {
  directory.write("grain.csv", "x_mm,y_mm\n0,0\n2,0\n2,1\n0,1\n");
  const auto read = stage(test::join(amount, ", shape = { polygon = \"grain.csv\" }"), sequential);
  const auto& outline = std::get<PolygonalOutline>(read.fillers.at(0).shape->outline);
  EXPECT_EQ(outline.corners.size(), 4U);
  EXPECT_FALSE(read.fillers.at(0).shape->angle);
}

TEST_F(DeckShapes, MistakesInShapes) {
  EXPECT_THAT(mistakes_of_shape("{ aspect = 0 }"),
              HasSubstr("a.filler.shape.aspect: expected a number from 0.05 to 20, got 0"));
  EXPECT_THAT(mistakes_of_shape("{ aspect = -1.5 }"), HasSubstr("got -1.5"));
  EXPECT_THAT(mistakes_of_shape("{ aspect = 30 }"), HasSubstr("expected a number from 0.05 to 20, got 30"));
  EXPECT_THAT(mistakes_of_shape("{ aspect = \"long\" }"), HasSubstr("a.filler.shape.aspect: "));
  EXPECT_THAT(mistakes_of_shape("{ }"), HasSubstr("expected exactly one of aspect, polygon"));
  directory.write("grain.csv", "x_mm,y_mm\n0,0\n2,0\n2,1\n0,1\n");
  EXPECT_THAT(mistakes_of_shape("{ aspect = 2, polygon = \"grain.csv\" }"),
              HasSubstr("expected exactly one of aspect, polygon"));
  EXPECT_THAT(mistakes_of_shape("{ aspect = 2, angle = \"3 mm\" }"), HasSubstr("expected an angle, got \"3 mm\""));
  EXPECT_THAT(mistakes_of_shape("{ aspect = 2, ratio = 2 }"), HasSubstr("unknown key \"ratio\""));
  EXPECT_THAT(mistakes_of_shape("\"ellipse\""), HasSubstr("a.filler.shape: expected { aspect = 1.5 }"));
  EXPECT_THAT(mistakes_of_shape("{ polygon = \"missing.csv\" }"), HasSubstr("missing.csv"));
}

TEST_F(DeckShapes, MistakesInThePolygonOfAFiller) {
  const auto shape = "{ polygon = \"grain.csv\" }";
  directory.write("grain.csv", "x_mm,y_mm\n0,0\n2,0\n0.5,0.5\n0,2\n");
  EXPECT_THAT(mistakes_of_shape(shape), HasSubstr("grain.csv:4: expected the corners of a convex polygon in order, but "
                                                  "this one points inwards"));
  directory.write("grain.csv", "x_mm,y_mm\n0,0\n2,0\n");
  EXPECT_THAT(mistakes_of_shape(shape), HasSubstr("three corners or more"));
  directory.write("grain.csv", "x_mm,z_mm\n0,0\n2,0\n");
  EXPECT_THAT(mistakes_of_shape(shape), HasSubstr("no column called y"));
}

TEST_F(DeckShapes, OtherPackingsPlaceDiscs) {
  const auto shape = test::join(amount, ", shape = { aspect = 1.5 }");
  EXPECT_THAT(mistakes(shape, "\"lubachevsky-stillinger\""),
              AllOf(HasSubstr("a.filler.shape: "), HasSubstr("packing.method = \"random-sequential\"")));
  EXPECT_THAT(
      mistakes(", sizes = { diameter = \"0.5 mm\" }, shape = { aspect = 1.5 }", "\"regular\", columns = 2, rows = 2"),
      HasSubstr("a regular packing has discs alone"));
  EXPECT_THAT(mistakes(shape, "\"laguerre\""), HasSubstr("have the shapes of its cells"));
  directory.write("particles.csv", "x_mm,y_mm,diameter_mm\n3,3,1\n");
  EXPECT_THAT(mistakes(", shape = { aspect = 1.5 }", "\"explicit\", discs = \"particles.csv\""),
              HasSubstr("all listed in its files"));
}

TEST_F(DeckShapes, ListedEllipses) {
  directory.write("particles.csv", "x_mm,y_mm,axis_1_mm,axis_2_mm,angle_deg\n1,2,1.5,0.5,90\n4,4,1,1,0\n");
  const auto listed =
      std::get<std::vector<Particle>>(listed_in(stage("", R"("explicit", particles = "particles.csv")")));
  ASSERT_EQ(listed.size(), 2U);
  EXPECT_EQ(std::get<Ellipse>(listed[0].shape).axes, (Vector<2>{1.5e-3, 0.5e-3}));
  EXPECT_EQ(listed[0].pose.centre(), (Vector<2>{1e-3, 2e-3}));
  EXPECT_NEAR(listed[0].pose.angle(), 0.5 * std::numbers::pi, 1e-15);
}

TEST_F(DeckShapes, ListedDiscsUnderTheNewName) {
  directory.write("particles.csv", "x_mm,y_mm,diameter_mm\n3,3,1\n");
  EXPECT_THAT(std::get<std::vector<Disc>>(listed_in(stage("", "\"explicit\", particles = \"particles.csv\""))),
              ElementsAre(Disc{{3e-3, 3e-3}, 1e-3}));
  EXPECT_THAT(mistakes("", "\"explicit\", particles = \"particles.csv\", discs = \"particles.csv\""),
              HasSubstr("packing.discs: "));
}

TEST_F(DeckShapes, MistakesInListedEllipses) {
  EXPECT_THAT(mistakes_of_table("x_mm,y_mm,axis_1_mm,axis_2_mm,angle_deg,diameter_mm\n1,2,1,1,0,1\n"),
              HasSubstr("expected either diameters, or axis_1, axis_2 and angle"));
  EXPECT_THAT(mistakes_of_table("x_mm,y_mm,axis_1_mm,angle_deg\n1,2,1,0\n"),
              HasSubstr("no column called axis_2, such as axis_2_um"));
  EXPECT_THAT(mistakes_of_table("x_mm,y_mm,axis_1_mm,axis_2_mm\n1,2,1,1\n"),
              HasSubstr("no column called angle, such as angle_deg"));
  EXPECT_THAT(mistakes_of_table("x_mm,y_mm,axis_1_mm,axis_2_mm,angle_mm\n1,2,1,1,0\n"), HasSubstr("angle_mm"));
  EXPECT_THAT(mistakes_of_table("x_mm,y_mm,axis_1_mm,axis_2_mm,angle_deg\n1,2,1,0,0\n3,3,-1,1,0\n"),
              AllOf(HasSubstr("particles.csv:2: expected positive axes, got 1 and 0"),
                    HasSubstr("particles.csv:3: expected positive axes, got -1 and 1")));
  EXPECT_THAT(mistakes_of_table("x_mm,y_mm,axis_1_mm,axis_2_mm,angle_deg\n1,7,1,1,0\n"),
              HasSubstr("particles.csv:2: expected a centre in the box"));
  EXPECT_THAT(mistakes_of_table("x_mm,y_mm,axis_1_mm,axis_2_mm,angle_deg\n0.4,3,1,0.5,0\n"),
              AllOf(HasSubstr("particle 1 (ellipse of 0.001 m x 0.0005 m"), HasSubstr("crosses a wall by 0.0001 m")));
  EXPECT_THAT(mistakes_of_table("x_mm,y_mm,axis_1_mm,axis_2_mm,angle_deg\n"), HasSubstr("at least one ellipse"));
}

TEST_F(DeckShapes, ListedPolygons) {
  directory.write("polygons.csv", "particle,x_mm,y_mm\n1,1,1\n1,2,1\n1,1,2\n2,4,4\n2,5,4\n2,5,5\n2,4,5\n");
  const auto listed = std::get<std::vector<Particle>>(listed_in(stage("", R"("explicit", polygons = "polygons.csv")")));
  ASSERT_EQ(listed.size(), 2U);
  EXPECT_NEAR(listed[0].pose.centre()[0], 4e-3 / 3.0, 1e-15);
  EXPECT_NEAR(area(listed[1].shape), 1e-6, 1e-18);
}

TEST_F(DeckShapes, ListedPolygonsBesideDiscs) {
  directory.write("discs.csv", "x_mm,y_mm,diameter_mm\n3,1,1\n");
  directory.write("polygons.csv", "particle,x_mm,y_mm\n0,4,4\n0,5,4\n0,5,5\n0,4,5\n");
  const auto listed = std::get<std::vector<Particle>>(
      listed_in(stage("", R"("explicit", particles = "discs.csv", polygons = "polygons.csv")")));
  ASSERT_EQ(listed.size(), 2U);
  EXPECT_EQ(std::get<Ellipse>(listed[0].shape).axes, (Vector<2>{1e-3, 1e-3}));
}

TEST_F(DeckShapes, MistakesInListedPolygons) {
  EXPECT_THAT(mistakes_of_polygons("particle,x_mm,y_mm\n0,1,1\n0,3,1\n0,1.5,1.5\n0,1,3\n"),
              HasSubstr("polygons.csv:4: particle 0: expected the corners of a convex polygon"));
  EXPECT_THAT(mistakes_of_polygons("x_mm,y_mm\n1,1\n3,1\n1,3\n"), HasSubstr("no column called particle"));
  EXPECT_THAT(mistakes_of_polygons("particle,x_mm,y_mm\n0,1,1\n0,3,1\n"), HasSubstr("three corners or more"));
  EXPECT_THAT(mistakes_of_polygons("particle,x_mm,y_mm\n0,1,1\n0,3,1\n0,1,3\n1,1,2\n1,3,2\n1,1,4\n"),
              AllOf(HasSubstr("packing.polygons: "), HasSubstr("particle 1"), HasSubstr("overlap by")));
  EXPECT_THAT(mistakes_of_polygons("particle,x_mm,y_mm\n0,7,1\n0,9,1\n0,7,3\n"), HasSubstr("a centre in the box"));
}

TEST_F(DeckShapes, SeveralFillersOfListedPolygons) {
  const auto deck = [](std::string_view file) {
    return test::join(test::materials, "[[stages]]\nname = \"a\"\nmatrix = \"binder\"\nbox = \"6 mm\"\ncells = 60\n",
                      R"(packing = { method = "explicit", polygons = ")", file,
                      "\" }\n[[stages.filler]]\nmaterial = \"hmx\"\n[[stages.filler]]\nmaterial = \"hmx\"\n",
                      test::tests);
  };
  directory.write("polygons.csv", "particle,x_mm,y_mm,filler\n0,1,1,1\n0,2,1,1\n0,1,2,1\n7,4,4,0\n7,5,4,0\n7,5,5,0\n");
  EXPECT_THAT(directory.study(deck("polygons.csv")).stages.at(0).packed_by<ExplicitPacking<2>>()->fillers,
              ElementsAre(1U, 0U));
  directory.write("several.csv", "particle,x_mm,y_mm,filler\n0,1,1,1\n0,2,1,0\n0,1,2,1\n");
  EXPECT_THAT(directory.mistakes(deck("several.csv")), HasSubstr("several.csv:3: particle 0: expected one filler"));
  directory.write("unknown.csv", "particle,x_mm,y_mm,filler\n0,1,1,2\n0,2,1,2\n0,1,2,2\n");
  EXPECT_THAT(directory.mistakes(deck("unknown.csv")), HasSubstr("expected the number of a filler, 0 to 1, got 2"));
  directory.write("missing.csv", "particle,x_mm,y_mm\n0,1,1\n0,2,1\n0,1,2\n");
  EXPECT_THAT(directory.mistakes(deck("missing.csv")), HasSubstr("expected a column called filler"));
}

}  // namespace
}  // namespace breccia
