#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "deck_stages.hpp"

namespace breccia {
namespace {

using test::DeckStages;
using test::random_packing;
using test::regular_packing;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr std::string_view two_fillers = R"(cells = 60
packing = { method = "lubachevsky-stillinger" }
[[stages.filler]]
material = "hmx"
fraction = 0.4
sizes = { diameter = "1 mm" }
gap = "0.1 mm"
[[stages.filler]]
material = "binder"
sizes = { list = ["0.5 mm"], counts = [3] }
coating = { material = "hmx", thickness = "20 um" }
)";

TEST_F(DeckStages, SeveralFillers) {
  const auto box = stage(two_fillers);
  ASSERT_EQ(box.fillers.size(), 2U);
  EXPECT_EQ(box.fillers[0].material.name, "hmx");
  EXPECT_EQ(box.fillers[0].fraction, 0.4);
  EXPECT_DOUBLE_EQ(box.fillers[0].gap, 1e-4);
  EXPECT_FALSE(box.fillers[0].coating);
  EXPECT_EQ(box.fillers[1].material.name, "binder");
  EXPECT_DOUBLE_EQ(box.fillers[1].gap, 0.05e-3) << "a tenth of its own smallest diameter";
  ASSERT_TRUE(box.fillers[1].coating);
  EXPECT_EQ(box.fillers[1].coating->material.name, "hmx");
  EXPECT_DOUBLE_EQ(box.fillers[1].coating->thickness, 20e-6);
  EXPECT_TRUE(box.is_random());
}

TEST_F(DeckStages, OneFillerInAnArrayIsOneInATable) {
  const auto listed = stage(
      "cells = 60\nfiller = [{ material = \"hmx\", sizes = { diameter = \"1 mm\" } }]\npacking = { "
      "method = \"regular\", columns = 2, rows = 2 }\n");
  ASSERT_EQ(listed.fillers.size(), 1U);
  EXPECT_EQ(listed.fillers[0].material.name, "hmx");
}

TEST_F(DeckStages, ValuesOfASecondFillerCanBeSet) {
  const auto changed = directory.study(deck(two_fillers),
                                       {"stages.0.filler.1.coating.thickness=30 um", "stages.a.filler.0.fraction=0.3"});
  EXPECT_DOUBLE_EQ(changed.stages[0].fillers[1].coating->thickness, 30e-6);
  EXPECT_EQ(changed.stages[0].fillers[0].fraction, 0.3);
}

TEST_F(DeckStages, ReportsTheMistakesOfAllFillersAtOnce) {
  const auto all = mistakes(R"(cells = 60
packing = { method = "lubachevsky-stillinger" }
[[stages.filler]]
material = "hmy"
fraction = 40
sizes = { diameter = "1 mm" }
[[stages.filler]]
material = "hmx"
fraction = 0.2
size = { diameter = "1 mm" }
coating = { material = "rdx", thicknes = "1 um" }
[[stages.filler]]
material = "hmx"
fraction = 0.1
sizes = { diameter = "9 mm" }
coating = 3
)");
  for (const auto* mistake :
       {"deck.toml:17:", "filler.0.material: unknown material \"hmy\"", "filler.0.fraction: expected a number between",
        "filler.1.size", "filler.1.coating.material: unknown material \"rdx\"", "unknown key \"thicknes\"",
        "filler.1.coating.thickness: missing", "filler.2.sizes: a particle of 9 mm",
        "filler.2.coating: expected a table"}) {
    EXPECT_THAT(all, HasSubstr(mistake));
  }
}

TEST_F(DeckStages, ReportsFillersThatDoNotGoTogether) {
  const auto with = [this](std::string_view fillers, std::string_view packing) {
    return mistakes(test::join("cells = 60\nfiller = ", fillers, "\npacking = { method = ", packing, " }\n"));
  };
  constexpr auto two_halves =
      R"([{ material = "hmx", fraction = 0.5, sizes = { diameter = "1 mm" } }, { material = "hmx", fraction = 0.6, sizes = { diameter = "2 mm" } }])";
  EXPECT_THAT(with(two_halves, random_packing), HasSubstr("the fractions of all fillers add up to 1.1"));
  EXPECT_THAT(
      with(
          R"([{ material = "hmx", sizes = { diameter = "1 mm" } }, { material = "binder", sizes = { diameter = "1 mm" } }])",
          regular_packing),
      HasSubstr("filler: expected one filler for a regular packing, got 2"));
  EXPECT_THAT(with("[]", random_packing), HasSubstr("filler: expected at least one table"));
  EXPECT_THAT(with("3", random_packing), HasSubstr("filler: expected a table"));
  EXPECT_THAT(
      with(
          R"({ material = "hmx", sizes = { diameter = "2.9 mm" }, coating = { material = "binder", thickness = "0.1 mm" } })",
          regular_packing),
      HasSubstr("particles of 3.1 mm with its coating touch"));
}

TEST_F(DeckStages, PhasesOfSeveralMaterialsHaveTheirNames) {
  const auto text = test::join(test::replaced(std::string(test::materials), "[materials.hmx]", "[materials.matrix]"),
                               "[[stages]]\nname = \"a\"\nmatrix = \"binder\"\nbox = \"6 mm\"\n",
                               test::replaced(std::string(two_fillers), "hmx", "matrix"), test::tests);
  EXPECT_THAT(directory.mistakes(text), HasSubstr("the material \"matrix\" has the name of another phase"));
}

TEST_F(DeckStages, AListOfDiscsTellsTheirFillers) {
  constexpr auto lines =
      "cells = 60\nfiller = [{ material = \"hmx\" }, { material = \"binder\" }]\npacking = { method = "
      "\"explicit\", discs = \"discs.csv\" }\n";
  directory.write("discs.csv", "x_mm,y_mm,diameter_mm,filler\n1,1,1,1\n3,3,1,0\n");
  EXPECT_THAT(stage(lines).packed_by<ExplicitPacking<2>>()->fillers, ElementsAre(1, 0));
  directory.write("discs.csv", "x_mm,y_mm,diameter_mm,filler\n1,1,1,1\n3,3,1,2\n3,5,1,0.5\n");
  EXPECT_THAT(mistakes(lines), AllOf(HasSubstr("discs.csv:3: expected the number of a filler, 0 to 1"),
                                     HasSubstr("discs.csv:4: expected the number of a filler, 0 to 1")));
  directory.write("discs.csv", "x_mm,y_mm,diameter_mm\n1,1,1\n3,3,1\n");
  EXPECT_THAT(mistakes(lines),
              HasSubstr("expected a column called filler with the number of the filler of each particle"));
}

TEST_F(DeckStages, CoatingsOfListedDiscsMustNotOverlap) {
  directory.write("discs.csv", "x_mm,y_mm,diameter_mm\n2,2,1\n3.1,2,1\n");
  const auto with = [](std::string_view thickness) {
    return test::join("cells = 60\nfiller = { material = \"hmx\", coating = { material = \"binder\", thickness = \"",
                      thickness, "\" } }\npacking = { method = \"explicit\", discs = \"discs.csv\" }\n");
  };
  EXPECT_EQ(stage(with("40 um")).fillers.size(), 1U);
  EXPECT_THAT(mistakes(with("70 um")), HasSubstr("packing.discs: "));
  EXPECT_THAT(mistakes(with("70 um")), HasSubstr("overlap by 4e-05 m"));
}

TEST_F(DeckStages, GrainsHaveAFractionOrFilms) {
  const auto with = [](std::string_view filler, std::string_view packing) {
    return test::join("cells = 60\nfiller = { material = \"hmx\", ", filler, " }\npacking = { method = \"laguerre\"",
                      packing, " }\n");
  };
  constexpr auto sizes = "sizes = { diameter = \"1 mm\" }";
  const auto by_fraction = stage(with(R"(fraction = "94 %", sizes = { diameter = "1 mm" })", ", seed = 7"));
  ASSERT_NE(by_fraction.packed_by<LaguerrePacking<2>>(), nullptr);
  EXPECT_EQ(by_fraction.fillers.front().fraction, 0.94);
  EXPECT_EQ(by_fraction.packed_by<LaguerrePacking<2>>()->seed, 7U);
  EXPECT_EQ(by_fraction.packed_by<LaguerrePacking<2>>()->walls, Walls::periodic);
  EXPECT_FALSE(by_fraction.packed_by<LaguerrePacking<2>>()->film);
  const auto by_film = stage(with(sizes, ", film = \"20 um\", walls = true"));
  EXPECT_EQ(by_film.packed_by<LaguerrePacking<2>>()->film, 20e-6);
  EXPECT_EQ(by_film.packed_by<LaguerrePacking<2>>()->walls, Walls::hard);
  EXPECT_EQ(by_film.packed_by<LaguerrePacking<2>>()->wall_film, WallFilm::half);
  EXPECT_FALSE(by_film.fillers.front().fraction);
  const auto cut = stage(with(sizes, R"(, film = "20 um", walls = "cut")"));
  EXPECT_EQ(cut.packed_by<LaguerrePacking<2>>()->walls, Walls::hard);
  EXPECT_EQ(cut.packed_by<LaguerrePacking<2>>()->wall_film, WallFilm::none);
  EXPECT_THAT(mistakes(with(sizes, ", film = \"20 um\", walls = \"cutt\"")), HasSubstr("packing.walls: "));
  EXPECT_THAT(mistakes(with("fraction = 0.9, gap = \"1 um\", coating = {}, sizes = { diameter = \"1 mm\" }",
                            ", film = \"20 um\"")),
              AllOf(HasSubstr("filler.fraction: "), HasSubstr("it follows from packing.film"),
                    HasSubstr("filler.gap: "), HasSubstr("filler.coating: ")));
  EXPECT_THAT(mistakes(with(sizes, "")), HasSubstr("filler.fraction: missing"));
  EXPECT_THAT(mistakes(with(sizes, ", film = \"0 um\"")), HasSubstr("packing.film: expected a positive length"));
}

TEST_F(DeckStages, GrainsMayGrowFromListedSites) {
  constexpr auto lines =
      "cells = 60\nfiller = { material = \"hmx\" }\npacking = { method = \"laguerre\", sites = \"sites.csv\", film = "
      "\"10 um\" }\n";
  directory.write("sites.csv", "x_mm,y_mm,weight_mm2\n1,1,0\n4,5,0.5\n");
  const auto read = stage(lines);
  ASSERT_EQ(read.packed_by<LaguerrePacking<2>>()->sites.size(), 2U);
  EXPECT_THAT(read.packed_by<LaguerrePacking<2>>()->sites[1].position,
              ElementsAre(testing::DoubleEq(4e-3), testing::DoubleEq(5e-3)));
  EXPECT_DOUBLE_EQ(read.packed_by<LaguerrePacking<2>>()->sites[1].weight, 0.5e-6);
  directory.write("sites.csv", "x_mm,y_mm\n1,1\n4,5\n");
  EXPECT_EQ(stage(lines).packed_by<LaguerrePacking<2>>()->sites[1].weight, 0.0) << "without weights all are equal";
  directory.write("sites.csv", "x_mm,y_mm,weight_mm2\n1,7,0\n4,-5,0\n");
  EXPECT_THAT(mistakes(lines), AllOf(HasSubstr("sites.csv:2: "), HasSubstr("sites.csv:3: ")));
  directory.write("sites.csv", "x_mm,y_mm,weight_mm2\n1,1,0\n1.1,1,9\n");
  EXPECT_THAT(mistakes(lines), HasSubstr("sites.csv:2: ")) << "the heavier site takes its place";
  directory.write("sites.csv", "x_mm,y_mm,weight_mm\n1,1,0\n");
  EXPECT_THAT(mistakes(lines), HasSubstr("sites.csv"));
  directory.write("sites.csv", "x_mm,y_mm,film_share\n1,1,0.5\n4,5,2\n");
  EXPECT_THAT(stage(lines).packed_by<LaguerrePacking<2>>()->film_shares, ElementsAre(0.5, 2.0));
  directory.write("sites.csv", "x_mm,y_mm,film_share\n1,1,0.5\n4,5,-2\n");
  EXPECT_THAT(mistakes(lines),
              AllOf(HasSubstr("sites.csv:3: "), HasSubstr("the share -2 of the films is not positive")));
  directory.write("sites.csv", "x_mm,y_mm,film_share_um\n1,1,0.5\n4,5,2\n");
  EXPECT_THAT(mistakes(lines), HasSubstr("film_share_um")) << "a share has no unit";
  directory.write("sites.csv", "x_mm,y_mm,weight_mm2\n1,1,0\n4,5,0.5\n");
  EXPECT_THAT(
      mistakes("cells = 60\nfiller = { material = \"hmx\", sizes = { diameter = \"1 mm\" } }\npacking = { method = "
               "\"laguerre\", sites = \"sites.csv\", film = \"10 um\", seed = 2 }\n"),
      AllOf(HasSubstr("filler.sizes: "), HasSubstr("packing.seed: ")));
}

}  // namespace
}  // namespace breccia
