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
using testing::Not;

TEST_F(DeckStages, CellsFromTheResolutionInMaterialPoints) {
  EXPECT_EQ(stage("cells = 60").cells, 60);
  EXPECT_EQ(stage("cells = [50, 100]").cells, 100);
  EXPECT_EQ(stage("cells = [50, 100]").coarser_cells, std::vector{50});
  EXPECT_EQ(stage("cells = [25, 50, 100]").coarser_cells, (std::vector{25, 50}));
  EXPECT_EQ(stage("resolution = \"66 /mm\"").cells, 198);
  EXPECT_EQ(stage("resolution = \"66.1 /mm\"").cells, 198);
}

TEST_F(DeckStages, AStageMayBeHomogeneous) {
  EXPECT_TRUE(stage("cells = 60").fillers.empty());
}

TEST_F(DeckStages, RegularPacking) {
  const auto box = stage(R"(cells = 60
filler = { material = "hmx", sizes = { diameter = "1.5 mm" } }
packing = { method = "regular", columns = 2, rows = 3 })");
  const auto& regular = box.fillers.at(0);
  EXPECT_EQ(regular.material.name, "hmx");
  EXPECT_DOUBLE_EQ(std::get<SingleSize>(regular.sizes.value()).diameter, 1.5e-3);
  EXPECT_EQ(box.packed_by<RegularPacking>()->columns, 2);
  EXPECT_EQ(box.packed_by<RegularPacking>()->rows, 3);
  EXPECT_FALSE(regular.fraction);
}

TEST_F(DeckStages, RandomPackingOfADistribution) {
  const auto box = stage(R"(cells = 60
packing = { method = "lubachevsky-stillinger", walls = false, seed = 7 }
[stages.filler]
material = "hmx"
fraction = 0.5
from = "0.1 mm"
to = "1 mm"
sizes = { lognormal = [{ weight = 3, median = "154 um", sigma = 0.76 }, { weight = 1, median = "12.7 um", sigma = 1.09 }] }
)");
  const auto& random = box.fillers.at(0);
  const auto& packing = *box.packed_by<LubachevskyStillingerPacking<2>>();
  EXPECT_EQ(packing.walls, Walls::periodic);
  EXPECT_EQ(packing.seed, 7U);
  EXPECT_EQ(random.fraction, 0.5);
  EXPECT_DOUBLE_EQ(random.smallest.value(), 1e-4);
  EXPECT_DOUBLE_EQ(random.largest.value(), 1e-3);
  const auto& components = std::get<LognormalSizes>(random.sizes.value()).components;
  ASSERT_EQ(components.size(), 2U);
  EXPECT_DOUBLE_EQ(components[0].weight, 0.75);
  EXPECT_DOUBLE_EQ(components[0].median, 154e-6);
  EXPECT_DOUBLE_EQ(components[1].sigma, 1.09);
}

TEST_F(DeckStages, RandomPackingOfATable) {
  directory.write("sizes.csv", "diameter_m,cumulative_volume_fraction\n1e-4,0\n2e-4,0.4\n3e-4,1\n");
  const auto box = stage(R"(cells = 60
filler = { material = "hmx", fraction = 0.5, to = "0.25 mm", sizes = "sizes.csv" }
packing = { method = "lubachevsky-stillinger" })");
  const auto& random = box.fillers.at(0);
  EXPECT_THAT(std::get<TabulatedSizes>(random.sizes.value()).diameters, ElementsAre(1e-4, 2e-4, 3e-4));
  EXPECT_DOUBLE_EQ(random.smallest.value(), 1e-4);
  EXPECT_DOUBLE_EQ(random.largest.value(), 2.5e-4);
  EXPECT_EQ(box.packed_by<LubachevskyStillingerPacking<2>>()->walls, Walls::periodic);
}

// As laboratories write them: from the coarsest sieve on, in per cent.
TEST_F(DeckStages, RandomPackingOfASieveAnalysis) {
  for (const auto* head : {"Size (um),Passing (%)", "sieve size [um],% passing", "diameter [um],passing %",
                           "Particle size [um],Percent passing", "SIZE [um],PERCENT PASSING [%]"}) {
    directory.write("sieves.csv", test::join(head, "\n2000,100\n1000,60\n500,0\n"));
    const auto sizes = filler(R"(filler = { material = "hmx", fraction = 0.5, sizes = "sieves.csv" }
packing = { method = "lubachevsky-stillinger" })")
                           .sizes.value();
    EXPECT_THAT(std::get<TabulatedSizes>(sizes).diameters, ElementsAre(5e-4, 1e-3, 2e-3)) << head;
    EXPECT_THAT(std::get<TabulatedSizes>(sizes).cumulative_volume_fractions, ElementsAre(0.0, 0.6, 1.0)) << head;
  }
}

TEST_F(DeckStages, RandomPackingOfAList) {
  const auto random = filler(R"(filler = { material = "hmx", sizes = { list = ["1 mm", "2 mm"] }, gap = "0.1 mm" }
packing = { method = "lubachevsky-stillinger" })");
  EXPECT_THAT(std::get<ListedSizes>(random.sizes.value()).diameters, ElementsAre(1e-3, 2e-3));
  EXPECT_DOUBLE_EQ(random.gap, 1e-4);
}

TEST_F(DeckStages, ExplicitPacking) {
  directory.write("discs.csv", "x_m,y_m,diameter_m\n1e-3,2e-3,1e-3\n");
  const auto box =
      stage("cells = 60\nfiller = { material = \"hmx\" }\npacking = { method = \"explicit\", discs = \"discs.csv\" }");
  EXPECT_THAT(std::get<std::vector<Disc>>(box.packed_by<ExplicitPacking<2>>()->particles),
              ElementsAre(Disc{{1e-3, 2e-3}, 1e-3}));
  EXPECT_FALSE(box.fillers.at(0).sizes);
}

// The box has 60 cells of 0.1 mm, so a point every 0.05 mm.
TEST_F(DeckStages, TheGapIsALengthOrAShareOfTheSmallestDiameterOrANumberOfPoints) {
  const auto filler_with = [&](std::string_view gap) {
    return filler(test::join(R"(filler = { material = "hmx", sizes = { list = ["1 mm", "0.7 mm"] })", gap,
                             " }\npacking = { method = \"lubachevsky-stillinger\" }"));
  };
  const auto gap_of = [&](std::string_view gap) { return filler_with(gap).gap; };
  EXPECT_EQ(gap_of(""), 0.07e-3);
  EXPECT_EQ(gap_of(", gap = \"10 %\""), 0.07e-3);
  EXPECT_EQ(gap_of(", gap = \"25%\""), 0.175e-3);
  EXPECT_EQ(gap_of(", gap = \"4 points\""), 0.2e-3);
  EXPECT_EQ(gap_of(", gap = \"0.5 points\""), 0.025e-3);
  EXPECT_EQ(gap_of(", gap = \"30 um\""), 30e-6);
  EXPECT_EQ(filler_with("").gap_source, GapSource::default_share);
  EXPECT_EQ(filler_with(", gap = \"10 %\"").gap_source, GapSource::diameter);
  EXPECT_EQ(filler_with(", gap = \"4 points\"").gap_source, GapSource::points);
  EXPECT_EQ(filler_with(", gap = \"30 um\"").gap_source, GapSource::length);
}

// 6 * (48 um / 300 / 2) in doubles is 4.8000000000000006e-07.
TEST_F(DeckStages, TheSameGapIsTheSameNumberHoweverItIsGiven) {
  const auto gap_of = [&](const char* gap) {
    const auto text = test::join(test::materials, "[[stages]]\nname = \"a\"\nmatrix = \"binder\"\nbox = \"48 um\"\n",
                                 "cells = 300\nfiller = { material = \"hmx\", sizes = { list = [\"4.8 um\"] }", gap,
                                 " }\npacking = { method = \"lubachevsky-stillinger\" }\n", test::tests);
    return directory.study(text).stages.at(0).fillers.at(0).gap;
  };
  EXPECT_EQ(gap_of(", gap = \"6 points\""), 0.48e-6);
  EXPECT_EQ(gap_of(", gap = \"0.48 um\""), 0.48e-6);
  EXPECT_EQ(gap_of(", gap = \"480 nm\""), 0.48e-6);
  EXPECT_EQ(gap_of(", gap = \"10 %\""), 0.48e-6);
  EXPECT_EQ(gap_of(""), 0.48e-6);
}

TEST_F(DeckStages, TheDefaultGapIsAShareOfTheSmallestDiameterOfACutDistribution) {
  const auto gap_of = [&](std::string_view sizes) {
    return filler(test::join("filler = { material = \"hmx\", fraction = 0.5, ", sizes,
                             " }\npacking = { method = \"lubachevsky-stillinger\" }"))
        .gap;
  };
  EXPECT_EQ(gap_of("sizes = { lognormal = [{ median = \"154 um\", sigma = 0.76 }] }, from = \"0.1 mm\", to = \"1 mm\""),
            10e-6);
  directory.write("sizes.csv", "diameter_m,cumulative_volume_fraction\n1e-4,0\n2e-4,0.4\n3e-4,1\n");
  EXPECT_EQ(gap_of("sizes = \"sizes.csv\""), 10e-6);
  EXPECT_EQ(gap_of("sizes = \"sizes.csv\", from = \"150 um\""), 15e-6);
  EXPECT_EQ(gap_of("sizes = \"sizes.csv\", from = \"50 um\""), 10e-6) << "the table begins above";
  EXPECT_EQ(gap_of("sizes = { diameter = \"1 mm\" }"), 100e-6);
}

TEST_F(DeckStages, TheFractionMayBeInPerCent) {
  const auto fraction_of = [&](std::string_view fraction) {
    return filler(test::join(R"(filler = { material = "hmx", sizes = { diameter = "1 mm" }, fraction = )", fraction,
                             " }\npacking = { method = \"lubachevsky-stillinger\" }"))
        .fraction;
  };
  EXPECT_EQ(fraction_of("\"35 %\""), 0.35);
  EXPECT_EQ(fraction_of("0.35"), 0.35);
  EXPECT_THAT(mistakes("fraction = \"35\", sizes = { diameter = \"1 mm\" }", random_packing),
              HasSubstr(R"(fraction: expected a number between 0 and 1, or per cent as in "35 %", got "35")"));
  EXPECT_THAT(mistakes("fraction = \"100 %\", sizes = { diameter = \"1 mm\" }", random_packing),
              HasSubstr(R"(got "100 %")"));
}

TEST_F(DeckStages, DiscsOfAnExplicitPackingMayCrossTheSidesOfAPeriodicBox) {
  directory.write("discs.csv", "x_m,y_m,diameter_m\n0.1e-3,3e-3,1e-3\n");
  const auto periodic = stage(
      "cells = 60\nfiller = { material = \"hmx\" }\npacking = { method = \"explicit\", discs = \"discs.csv\", walls = "
      "false }");
  EXPECT_EQ(periodic.packed_by<ExplicitPacking<2>>()->walls, Walls::periodic);
  EXPECT_THAT(mistakes_with("\"explicit\", discs = \"discs.csv\""), HasSubstr("crosses a wall by 0.0004 m"));
  directory.write("discs.csv", "x_m,y_m,diameter_m\n0.1e-3,3e-3,1e-3\n5.8e-3,3e-3,1e-3\n");
  EXPECT_THAT(mistakes_with("\"explicit\", discs = \"discs.csv\", walls = false"), HasSubstr("overlap by 0.0007 m"))
      << "across the sides";
  directory.write("discs.csv", "x_m,y_m,diameter_m\n-0.1e-3,3e-3,1e-3\n");
  EXPECT_THAT(mistakes_with("\"explicit\", discs = \"discs.csv\", walls = false"),
              HasSubstr("discs.csv:2: expected a centre in the box"));
}

TEST_F(DeckStages, ReportsUnavailableFeaturesByName) {
  const auto shapes_elsewhere = HasSubstr(
      "ellipses and polygons are the shape of a filler, shape = { aspect = 1.5 } with packing.method = "
      "\"random-sequential\"");
  EXPECT_THAT(mistakes("sizes = { diameter = \"1 mm\" }", "\"ellipses\""), shapes_elsewhere);
  const auto image_elsewhere = HasSubstr("an image is a packing without a filler: packing = { method = \"image\", ");
  EXPECT_THAT(mistakes("image = \"grains.png\", sizes = { diameter = \"1 mm\" }", regular_packing), image_elsewhere);
  EXPECT_THAT(mistakes("cells = 60\nimage = \"grains.png\"\n"), image_elsewhere);
  directory.write("grains.PNG", "\x89PNG\r\n\x1a\n");
  EXPECT_THAT(
      mistakes_with("\"explicit\", discs = \"grains.PNG\""),
      AllOf(HasSubstr("expected a CSV file with columns x_m, y_m, diameter_m, got grains.PNG"), image_elsewhere));
}

TEST_F(DeckStages, MistakesInTheGrid) {
  for (const auto* cells : {"[100]", "[100, 50]", "[100, 100]", "[10, 20, 30, 40]"}) {
    EXPECT_THAT(mistakes(std::string("cells = ") + cells),
                HasSubstr("a.cells: expected an integer, or two or three rising"));
  }
  EXPECT_THAT(mistakes("cells = 1"), HasSubstr("a.cells: expected an integer from 2 to 1048576, got 1"));
  EXPECT_THAT(mistakes("cells = 60\nresolution = \"66 /mm\""), HasSubstr("expected exactly one of cells, resolution"));
  EXPECT_THAT(mistakes("resolution = \"0.1 /mm\""), HasSubstr("between 2 and 1048576 cells per side, got 0"));
  EXPECT_THAT(mistakes("resolution = \"66 mm\""), HasSubstr("expected a reciprocal length, got \"66 mm\""));
}

TEST_F(DeckStages, StagesNeedDifferentNames) {
  EXPECT_THAT(directory.mistakes(test::join(test::materials, test::stage, test::stage, test::tests)),
              HasSubstr("stages.HB-1.name: another stage is called \"HB-1\""));
}

TEST_F(DeckStages, NamesAreNotEmpty) {
  const auto mistakes_with_empty = [this](const std::string& word) {
    const auto stage = test::replaced(std::string(test::stage), "\"" + word + "\"", "\"\"");
    return directory.mistakes(test::join(test::materials, stage, test::tests));
  };
  for (const auto* word : {"HB-1", "binder", "hmx"}) {
    EXPECT_THAT(mistakes_with_empty(word), HasSubstr("expected a text that is not empty")) << word;
  }
  EXPECT_THAT(mistakes_with_empty("lubachevsky-stillinger"), HasSubstr("packing.method: expected one of"));
}

TEST_F(DeckStages, ListedSizesMayBeCounted) {
  const auto counted = filler(R"(filler = { material = "hmx", sizes = { list = ["1 mm", "2 mm"], counts = [1, 3] } }
packing = { method = "lubachevsky-stillinger" })");
  EXPECT_THAT(std::get<ListedSizes>(counted.sizes.value()).diameters, ElementsAre(1e-3, 2e-3, 2e-3, 2e-3));
  EXPECT_THAT(mistakes("sizes = { list = [\"1 mm\"], counts = [1, 3] }", random_packing),
              HasSubstr("sizes.counts: expected as many as in list, 1, got 2"));
  EXPECT_THAT(mistakes("sizes = { list = [\"1 mm\"], counts = [0] }", random_packing), HasSubstr("sizes.counts"));
}

TEST_F(DeckStages, AnEarlierStageServesAsMatrix) {
  const auto stage_with = [](const std::string& name, const std::string& matrix) {
    return test::join("[[stages]]\nname = \"", name, "\"\nmatrix = \"", matrix, "\"\nbox = \"1 mm\"\ncells = 4\n");
  };
  const auto study = directory.study(test::join(test::materials, test::stage, stage_with("b", "HB-1"), test::tests));
  EXPECT_EQ(std::get<EarlierStage>(study.stages[1].matrix).name, "HB-1");
  for (const auto* later : {"c", "b"}) {
    EXPECT_THAT(directory.mistakes(test::join(test::materials, test::stage, stage_with("b", later),
                                              stage_with("c", "binder"), test::tests)),
                HasSubstr(later == std::string_view("b") ? "stages.b.matrix: a stage cannot be its own matrix"
                                                         : "stages.b.matrix: the stage \"c\" is no earlier one: "));
  }
  EXPECT_THAT(directory.mistakes(test::join(test::materials, stage_with("binder", "binder"), test::tests)),
              HasSubstr("stages.binder.name: a material is called \"binder\""));
}

TEST_F(DeckStages, MistakesInThePacking) {
  EXPECT_THAT(mistakes("sizes = { diameter = \"1 mm\" }", "\"randm\""), HasSubstr("packing.method: expected one of"));
  EXPECT_THAT(mistakes("sizes = { diameter = \"1 mm\" }", "\"regular\", columns = 0, rows = 2"),
              HasSubstr("packing.columns: expected an integer from 1 to 10000, got 0"));
  EXPECT_THAT(mistakes("sizes = { list = [\"1 mm\"] }", "\"lubachevsky-stillinger\", seed = -1"),
              HasSubstr("packing.seed: expected a non-negative integer, got -1"));
  EXPECT_THAT(mistakes("cells = 60\nfiller = { material = \"hmx\", sizes = { diameter = \"1 mm\" } }\n"),
              HasSubstr("a.packing: missing, expected a table"));
  EXPECT_THAT(mistakes("cells = 60\npacking = { method = \"regular\" }\n"), HasSubstr("a.packing: there is no filler"));
  directory.write("discs.csv", "x_m,y_m,diameter_m\n1,2e-3,1e-3\n");
  EXPECT_THAT(mistakes("gap = \"1 um\"", "\"explicit\", discs = \"discs.csv\""),
              HasSubstr("discs.csv:2: expected a centre in the box"));
  EXPECT_THAT(mistakes("gap = \"1 um\"", "\"explicit\", discs = \"discs.csv\""), HasSubstr("filler.gap: only"));
  directory.write("discs.csv", "x_m,y_m,diameter_m\n1e-3,2e-3,0\n");
  EXPECT_THAT(mistakes("fraction = 0.5", "\"explicit\", discs = \"discs.csv\""),
              HasSubstr("filler.fraction: the particles"));
  EXPECT_THAT(mistakes("fraction = 0.5", "\"explicit\", discs = \"discs.csv\""),
              HasSubstr("expected a positive diameter"));
  directory.write("discs.csv", "x_mm,y_mm,diameter_um\n1,2,-8\n7,2,8\n");
  EXPECT_THAT(mistakes("gap = \"1 um\"", "\"explicit\", discs = \"discs.csv\""),
              AllOf(HasSubstr("discs.csv:2: expected a positive diameter, got -8\n"),
                    HasSubstr("discs.csv:3: expected a centre in the box, 0 to 6 mm, got (7, 2)")))
      << "numbers as they are in the file";
}

TEST_F(DeckStages, MistakesInTheAmount) {
  EXPECT_THAT(mistakes("fraction = 1.2, sizes = { diameter = \"1 mm\" }", random_packing),
              HasSubstr("filler.fraction: expected a number between 0 and 1, or per cent as in \"35 %\", got 1.2"));
  EXPECT_THAT(mistakes("sizes = { diameter = \"1 mm\" }", random_packing), HasSubstr("filler.fraction: missing"));
  EXPECT_THAT(mistakes("fraction = 0.5, sizes = { list = [\"1 mm\"] }", random_packing),
              HasSubstr("filler.fraction: a list of sizes is packed as it is"));
  EXPECT_THAT(mistakes("fraction = 0.5, sizes = { diameter = \"1 mm\" }", regular_packing),
              HasSubstr("filler.fraction: a regular packing has the fraction that follows"));
  EXPECT_THAT(mistakes("fraction = 0.5, gap = \"1 s\", sizes = { diameter = \"1 mm\" }", random_packing),
              HasSubstr("filler.gap: expected a length such as \"0.5 um\", a share of the smallest diameter such as"));
  for (const auto* gap : {"\"-1 um\"", "\"-5 %\"", "\"1e300 %\"", "\"ten %\"", "\"-6 points\""}) {
    EXPECT_THAT(mistakes(test::join("sizes = { list = [\"1 mm\"] }, gap = ", gap), random_packing),
                HasSubstr("filler.gap: expected a length"))
        << gap;
  }
  EXPECT_THAT(mistakes("sizes = { list = [\"1 mm\"] }, gap = 3", random_packing),
              HasSubstr("filler.gap: expected text in quotes"));
  EXPECT_THAT(mistakes("sizes = { list = [\"1 mm\"] }, gap = \"900 %\"", random_packing),
              HasSubstr("a gap of 9 mm does not fit into a box of 6 mm"));
}

TEST_F(DeckStages, MistakesInTheSizes) {
  const auto lognormal = "sizes = { lognormal = [{ median = \"1 mm\", sigma = 1 }] }, fraction = 0.5, ";
  EXPECT_THAT(mistakes("fraction = 0.5", random_packing), HasSubstr("filler.sizes: missing, expected a file"));
  EXPECT_THAT(mistakes("fraction = 0.5, sizes = 3", random_packing), HasSubstr("filler.sizes: expected a file"));
  EXPECT_THAT(mistakes("fraction = 0.5, sizes = {}", random_packing),
              HasSubstr("exactly one of diameter, list, passing"));
  EXPECT_THAT(mistakes(test::join(lognormal, "from = \"2 mm\", to = \"1 mm\""), random_packing),
              HasSubstr("filler.from: expected less than 1 mm (to), got 2 mm"));
  EXPECT_THAT(mistakes(test::join(lognormal, "from = \"2 mm\""), random_packing), HasSubstr("filler.to: missing"));
  EXPECT_THAT(mistakes("from = \"1 um\", sizes = { diameter = \"1 mm\" }", regular_packing),
              HasSubstr("filler.from: only a distribution"));
  EXPECT_THAT(mistakes("from = \"1 um\", to = \"1 kg\", sizes = \"none.csv\"", random_packing),
              AllOf(HasSubstr("filler.sizes: no such file"), Not(HasSubstr("filler.from")),
                    HasSubstr("filler.to: expected a length")));
  EXPECT_THAT(mistakes("sizes = { list = [\"1 mm\"] }", regular_packing), HasSubstr("a regular packing takes"));
  EXPECT_THAT(mistakes("sizes = { diameter = \"3.5 mm\" }", regular_packing),
              HasSubstr("particles of 3.5 mm touch at a regular spacing of 3 mm"));
  EXPECT_THAT(mistakes("sizes = { diameter = \"3 mm\" }", regular_packing),
              HasSubstr("particles of 3 mm touch at a regular spacing of 3 mm"));
  EXPECT_THAT(mistakes("sizes = { list = [\"1 mm\", \"7 mm\"] }", random_packing),
              HasSubstr("a particle of 7 mm does not fit into a box of 6 mm"));
}

TEST_F(DeckStages, ReportsAnEmptyListOfCellsOnce) {
  const auto message = mistakes("cells = []\n");
  EXPECT_THAT(message, HasSubstr("cells: expected at least one, got an empty array"));
  EXPECT_EQ(message.find("cells: "), message.rfind("cells: ")) << message;
}

TEST_F(DeckStages, MistakesInATableOfSizes) {
  const auto mistake_of = [&](std::string_view rows, std::string_view keys = "") {
    directory.write("sizes.csv", test::join("diameter_m,cumulative_volume_fraction\n", rows));
    return mistakes(test::join("fraction = 0.5, sizes = \"sizes.csv\"", keys), random_packing);
  };
  EXPECT_THAT(mistake_of("1e-4,0\n"), HasSubstr("sizes.csv: expected at least two rows"));
  EXPECT_THAT(mistake_of("1e-4,0\n3e-4,0.5\n2e-4,1\n"),
              HasSubstr("sizes.csv:3: expected a volume fraction that is not below that up to a smaller diameter"));
  EXPECT_THAT(mistake_of("2e-4,0\n1e-4,1\n"),
              HasSubstr("sizes.csv:2: expected a volume fraction that is not below that up to a smaller diameter"));
  EXPECT_THAT(mistake_of("1e-4,0\n2e-4,20\n"),
              HasSubstr("sizes.csv:3: expected the volume fraction up to each diameter, from 0 to 1, or in per cent"));
  EXPECT_THAT(mistake_of("1e-4,0\n0,0.2\n2e-4,0.1\n-3e-4,1\n4e-4,1\n"),
              AllOf(HasSubstr("sizes.csv:3: expected a positive diameter"), HasSubstr("sizes.csv:5: expected")))
      << "all of them";
  EXPECT_THAT(mistake_of("1e-4,0\n2e-4,0.9\n"),
              HasSubstr("stages.a.filler.sizes: sizes.csv: 10 % of the volume do not pass 200 um, the largest size"));
  EXPECT_THAT(mistake_of("1e-4,0\n2e-4,1\n", ", from = \"1 mm\", to = \"2 mm\""),
              HasSubstr("the table has no sizes from 1 mm to 2 mm: it covers 100 um to 200 um"));
}

TEST_F(DeckStages, RefusesSizesAndBoxesOutOfRange) {
  constexpr auto one_size = "fraction = 0.5, sizes = { diameter = \"1 mm\" }, gap = ";
  EXPECT_THAT(mistakes(test::join(one_size, "\"inf points\""), random_packing), HasSubstr("got \"inf points\""));
  EXPECT_THAT(mistakes(test::join(one_size, "\"6 mm\""), random_packing),
              HasSubstr("stages.a.filler.gap: a gap of 6 mm does not fit into a box of 6 mm"));
  EXPECT_THAT(mistakes("sizes = { list = [\"1 um\", \"2 um\"], counts = [1000000, 1] }", random_packing),
              HasSubstr("counts: expected at most 1000000 particles, got 1000001"));
  EXPECT_THAT(mistakes("fraction = 0.5, from = \"1 um\", to = \"1 mm\", sizes = { lognormal = [{ median = \"154 m\", "
                       "sigma = 0.76 }] }",
                       random_packing),
              HasSubstr("stages.a.filler.sizes: size distribution: nothing of it"));
  EXPECT_THAT(directory.mistakes(test::join(test::materials, "[[stages]]\nname = \"a\"\nmatrix = \"binder\"\n",
                                            "box = \"1e200 m\"\ncells = 60\n", test::tests)),
              HasSubstr("stages.a.box: expected a length from 0.001 nm to 1e+06 m, got \"1e200 m\""));
}

}  // namespace
}  // namespace breccia
