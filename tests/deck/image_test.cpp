// Tests of images in the deck.

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/deck/read_sweep.hpp"

#include "decks.hpp"
#include "io/hdf5.hpp"
#include "io/text_file.hpp"
#include "rasters/npy.hpp"
#include "rasters/png.hpp"
#include "study/identity.hpp"

namespace breccia {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr auto two_labels = R"([{ value = 0, material = "binder" }, { value = 7, material = "hmx" }])";

class DeckImage : public testing::Test {
 protected:
  DeckImage() {
    // The lower left quarter of the picture is hmx.
    const std::array<std::uint16_t, 16> values = {7, 7, 0, 0, 7, 7, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    const std::array<std::size_t, 2> extents = {4, 4};
    write_npy(directory.path() / "scan.npy", extents, values);
  }

  /// A deck with one stage, given by keys of the packing, and of the stage.
  [[nodiscard]] static std::string deck(std::string_view packing, std::string_view stage = "") {
    return test::join(test::materials, "[[stages]]\nname = \"a\"\nmatrix = \"binder\"\n", stage,
                      "\npacking = { method = \"image\", ", packing, " }\n", test::tests);
  }
  [[nodiscard]] static std::string keys(std::string_view file, std::string_view pixel = "pixel = \"2 um\"",
                                        std::string_view labels = two_labels) {
    return fmt::format("file = \"{}\", {}, labels = {}", file, pixel, labels);
  }
  [[nodiscard]] Study study(std::string_view packing, std::string_view stage = "") const {
    return directory.study(deck(packing, stage));
  }
  [[nodiscard]] std::string mistakes(std::string_view packing, std::string_view stage = "") const {
    return directory.mistakes(deck(packing, stage));
  }
  void write(const std::string& name, std::vector<std::size_t> extents, const std::vector<std::uint16_t>& values) {
    write_npy(directory.path() / name, extents, values);
  }

  test::DeckDirectory directory;
};

TEST_F(DeckImage, IsInTheMemoryOnceForAllTasksOfASweep) {
  const auto file = directory.written("deck.toml", deck(keys("scan.npy")));
  const auto sweep =
      read_sweep(file, {}, {"tests.points_per_decade=[5, 10]", R"(stages.a.packing.pixel=["2 um", "3 um"])"});
  ASSERT_EQ(sweep.tasks.size(), 4U);
  const auto image = [&](std::size_t task) {
    return sweep.tasks[task].study.stages.at(0).packed_by<ImagePacking<2>>()->image;
  };
  EXPECT_EQ(image(0), image(2));
  EXPECT_EQ(image(1), image(3));
  EXPECT_NE(image(0), image(1)) << "pixels of another size";
  EXPECT_EQ(image(1)->labels, image(0)->labels);
  EXPECT_DOUBLE_EQ(image(1)->pixel_side, 3e-6);
  EXPECT_EQ(sweep.tasks[1].study.provenance.file_hashes, sweep.tasks[0].study.provenance.file_hashes);
}

TEST_F(DeckImage, IsABoxOfPixels) {
  const auto stage = study(keys("scan.npy")).stages.at(0);
  EXPECT_EQ(stage.side, 8e-6);
  EXPECT_EQ(stage.cells, 2) << "one point a pixel";
  ASSERT_EQ(stage.fillers.size(), 1U);
  EXPECT_EQ(stage.fillers[0].material.name, "hmx");
  ASSERT_NE(stage.packed_by<ImagePacking<2>>(), nullptr);
  EXPECT_THAT(stage.packed_by<ImagePacking<2>>()->image->labels,
              ElementsAre(1, 1, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0));
  EXPECT_EQ(stage.packed_by<ImagePacking<2>>()->image->walls, Walls::periodic) << "by default";
  EXPECT_FALSE(stage.packed_by<ImagePacking<2>>()->segmentation);
}

TEST_F(DeckImage, TheGridMayBeAnother) {
  EXPECT_EQ(study(keys("scan.npy"), "cells = 7").stages.at(0).cells, 7);
  const auto grids = study(keys("scan.npy"), "cells = [3, 5]").stages.at(0);
  EXPECT_EQ(grids.grids(), (std::vector{3, 5}));
  EXPECT_EQ(study(keys("scan.npy"), "resolution = \"2 /um\"").stages.at(0).cells, 8);
}

TEST_F(DeckImage, TheBoxMayStandForThePixel) {
  const auto stage = study(keys("scan.npy", "periodic = true"), "box = \"1 mm\"").stages.at(0);
  EXPECT_EQ(stage.side, 1e-3);
  EXPECT_DOUBLE_EQ(stage.packed_by<ImagePacking<2>>()->image->pixel_side, 0.25e-3);
  EXPECT_EQ(stage.packed_by<ImagePacking<2>>()->image->walls, Walls::periodic);
  EXPECT_EQ(study(keys("scan.npy"), "box = \"8.000000001 um\"").stages.at(0).side, 8.000000001e-6) << "both agree";
}

TEST_F(DeckImage, OfAPeriodicBoxIsTestedUnderThePeriodicBoundary) {
  EXPECT_THAT(study(keys("scan.npy", "pixel = \"1 um\", periodic = true")).tests.boundaries,
              ElementsAre(Boundary::periodic));
  EXPECT_THAT(study(keys("scan.npy")).tests.boundaries, ElementsAre(Boundary::periodic)) << "by default";
  EXPECT_EQ(study(keys("scan.npy", "pixel = \"1 um\", periodic = false")).tests.boundaries.size(), 2U);
}

TEST_F(DeckImage, IsAWindowWhereTheTestsNameABoundaryThatCuts) {
  const auto walls = [&](const std::string& boundaries, std::string_view pixel = "pixel = \"1 um\"") {
    const auto read = directory.study(deck(keys("scan.npy", pixel)) + "boundaries = " + boundaries + "\n");
    return read.stages.at(0).packed_by<ImagePacking<2>>()->image->walls;
  };
  EXPECT_EQ(walls(R"(["displacement", "traction"])"), Walls::hard);
  EXPECT_EQ(walls(R"(["displacement"])", "pixel = \"1 um\", periodic = true"), Walls::periodic);
  EXPECT_EQ(walls(R"(["periodic"])"), Walls::periodic);
  EXPECT_EQ(walls(R"(["periodic"])", "pixel = \"1 um\", periodic = false"), Walls::hard);
}

TEST_F(DeckImage, MayBeAPartOfAPicture) {
  // Columns rise by one, rows from the top by ten.
  std::vector<std::uint16_t> values;  // from the bottom row
  for (const int row : {3, 2, 1, 0}) {
    for (int column = 0; column < 5; ++column) values.push_back(static_cast<std::uint16_t>(10 * row + column));
  }
  write("ramp.npy", {5, 4}, values);
  const auto part = [](std::string_view crop) { return fmt::format("crop = {{ {} }}, pixel = \"1 um\"", crop); };
  const auto labels = R"([{ value = 12, material = "binder" }, { value = 13, material = "hmx" },
                         { value = 22, material = "hmx" }, { value = 23, material = "binder" }])";
  const auto deck = keys("ramp.npy", part("left = 2, top = 1, width = 2, height = 2"), labels);
  const auto stage = study(deck, "cells = 2").stages.at(0);
  const auto* const pixels = stage.packed_by<ImagePacking<2>>();
  EXPECT_THAT(pixels->image->labels, ElementsAre(1, 0, 0, 1)) << "the lower row first";
  EXPECT_EQ(stage.side, 2e-6);
  EXPECT_EQ(pixels->crop->top, 1U);
  EXPECT_THAT(mistakes(keys("ramp.npy", part("left = 2, top = 3, width = 2, height = 2"))),
              HasSubstr("packing.crop: the pixels 3 to 5 from the top reach beyond a picture of 5 x 4"));
  EXPECT_THAT(mistakes(keys("ramp.npy", part("left = -1, top = 0, width = 0, height = 2, depth = 1"))),
              AllOf(HasSubstr("packing.crop.left: "), HasSubstr("packing.crop.width: "),
                    HasSubstr("crop.depth: a box of two dimensions takes one image")));
  EXPECT_THAT(mistakes(keys("ramp.npy", part("left = 0, top = 0, width = 3, height = 2"))),
              HasSubstr("packing.crop: expected a square image, since boxes are square, got 3 x 2 pixels"));
}

constexpr auto two_sides = R"({ dark = "binder", bright = "hmx" })";

TEST_F(DeckImage, ThatIsGreyHasTwoSidesOfAThreshold) {
  write("grey.npy", {2, 2}, {40, 60, 200, 90});
  const auto labels = [&](std::string_view threshold, std::string_view sides = two_sides,
                          std::string_view file = "grey.npy") {
    const auto stage =
        study(keys(file, fmt::format("pixel = \"1 um\", threshold = {}", threshold), sides), "cells = 2");
    return stage.stages.at(0).packed_by<ImagePacking<2>>()->image->labels;
  };
  EXPECT_THAT(labels("\"otsu\""), ElementsAre(0, 0, 1, 0));
  EXPECT_THAT(labels("60"), ElementsAre(0, 0, 1, 1)) << "60 itself is dark";
  EXPECT_THAT(labels("59.5"), ElementsAre(0, 1, 1, 1));
  EXPECT_THAT(labels("60", R"({ dark = "hmx", bright = "binder" })"), ElementsAre(1, 1, 0, 0));
  write("speck.npy", {4, 4}, {40, 40, 100, 100, 40, 200, 100, 100, 40, 40, 100, 100, 40, 40, 100, 100});
  EXPECT_THAT(labels("70", two_sides, "speck.npy"), ElementsAre(0, 0, 1, 1, 0, 1, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1));
  EXPECT_THAT(labels("70, smooth = 3", two_sides, "speck.npy"),
              ElementsAre(0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1));
}

TEST_F(DeckImage, MistakesInAThreshold) {
  write("grey.npy", {2, 2}, {40, 60, 200, 90});
  const auto with = [&](std::string_view further, std::string_view labels = two_sides) {
    return mistakes(keys("grey.npy", fmt::format("pixel = \"1 um\"{}", further), labels), "cells = 2");
  };
  EXPECT_THAT(with("", R"([{ value = 40, material = "binder" }])"),
              AllOf(HasSubstr("values without a label: "),
                    HasSubstr("packing.labels: in a grey picture a threshold divides the values: packing.threshold = "
                              "\"otsu\" with labels = { dark = \"...\", bright = \"...\" } (docs/tutorial-image.md)")));
  EXPECT_THAT(with(""),
              HasSubstr("dark and bright are the two sides of packing.threshold: expected threshold = \"otsu\" "
                        "or a grey value, too"));
  EXPECT_THAT(with(", threshold = \"ostu\""), HasSubstr("did you mean \"otsu\"?"));
  EXPECT_THAT(with(", threshold = \"45 %\""), HasSubstr("packing.threshold: expected \"otsu\""));
  EXPECT_THAT(with(", threshold = nan"), HasSubstr("packing.threshold: expected a number"));
  EXPECT_THAT(with(", threshold = [40]"),
              HasSubstr("packing.threshold: expected \"otsu\" or a grey value of the picture, such as 115"));
  EXPECT_THAT(with(", threshold = 60, smooth = 2"), HasSubstr("packing.smooth: "));
  EXPECT_THAT(with(", smooth = 3", two_labels), HasSubstr("packing.smooth: the medians of grey values"));
  EXPECT_THAT(with(", threshold = 60", two_labels),
              HasSubstr("packing.labels: expected the materials of the pixels up to packing.threshold and above it"));
  EXPECT_THAT(with(", threshold = 60", R"({ dark = "hmx", bright = "hmx" })"),
              HasSubstr("packing.labels: neither side of the threshold is the matrix of the stage, \"binder\""));
  EXPECT_THAT(with(", threshold = 60", R"({ dark = "binder", bright = "binder" })"),
              HasSubstr("packing.labels: both sides of the threshold are \"binder\""));
  EXPECT_THAT(with(", threshold = 60", R"({ dark = "binder", light = "hmx" })"),
              AllOf(HasSubstr("packing.labels.bright: missing"), HasSubstr("unknown key \"light\"")));
  EXPECT_THAT(with(", threshold = 60", R"({ dark = "binder", bright = "hmxx" })"),
              HasSubstr("packing.labels.bright: unknown material \"hmxx\", did you mean \"hmx\"?"));
  const auto otsu = R"(pixel = "1 um", threshold = "otsu")";
  write("flat.npy", {2, 2}, {40, 40, 40, 40});
  EXPECT_THAT(mistakes(keys("flat.npy", otsu, two_sides), "cells = 2"),
              HasSubstr("packing.threshold: all pixels have the grey value 40"));
  const std::array<std::uint8_t, 4> pixels = {0, 1, 2, 1};
  const std::array<Rgb, 3> palette = {Rgb{0, 0, 0}, Rgb{255, 0, 0}, Rgb{9, 9, 9}};
  directory.write("palette.png", encode_png(2, pixels, palette));
  EXPECT_THAT(mistakes(keys("palette.png", otsu, two_sides), "cells = 2"),
              HasSubstr("packing.threshold: the values of this picture are numbers of the colours of a palette"));
}

TEST_F(DeckImage, SeveralValuesMayHaveOneMaterial) {
  write("three.npy", {2, 2}, {1, 2, 3, 1});
  const auto labels =
      R"([{ value = 3, material = "binder" }, { value = 1, material = "hmx" }, { value = 2, material = "hmx" }])";
  const auto stage = study(keys("three.npy", "pixel = \"1 um\"", labels), "cells = 2").stages.at(0);
  EXPECT_EQ(stage.fillers.size(), 1U);
  EXPECT_THAT(stage.packed_by<ImagePacking<2>>()->image->labels, ElementsAre(1, 1, 0, 1));
}

TEST_F(DeckImage, TheMatrixMayBeAnEarlierStage) {
  const auto text =
      test::join(test::materials, test::stage,
                 "[[stages]]\nname = \"b\"\nmatrix = \"HB-1\"\npacking = { method = \"image\", file = "
                 "\"scan.npy\", pixel = \"1 mm\", labels = [{ value = 0, material = \"HB-1\" }, { value = "
                 "7, material = \"hmx\" }] }\n",
                 test::tests);
  const auto stage = directory.study(text).stages.at(1);
  EXPECT_EQ(std::get<EarlierStage>(stage.matrix).name, "HB-1");
  EXPECT_EQ(stage.packed_by<ImagePacking<2>>()->image->labels.front(), 1);
}

TEST_F(DeckImage, OnePageOfAStackMayBeTaken) {
  write("stack.npy", {2, 2, 2}, {7, 7, 7, 7, 0, 0, 0, 7});
  const auto stage = study(keys("stack.npy", "pixel = \"1 um\", page = 2"), "cells = 2").stages.at(0);
  EXPECT_THAT(stage.packed_by<ImagePacking<2>>()->image->labels, ElementsAre(0, 0, 0, 1));
  EXPECT_THAT(mistakes(keys("stack.npy"), "cells = 2"),
              HasSubstr("stages.a.packing.file: a stack of 2 images: expected one image in a box of two dimensions; "
                        "packing.page = 1 takes the first one, dimensions = 3 the whole stack"));
  EXPECT_THAT(mistakes(keys("stack.npy", "pixel = \"1 um\", page = 3"), "cells = 2"),
              HasSubstr("packing.page: expected a page from 1 to 2, got 3"));
  EXPECT_THAT(mistakes(keys("stack.npy", "pixel = \"1 um\", page = 0"), "cells = 2"), HasSubstr("packing.page: "));
  EXPECT_EQ(study(keys("scan.npy", "pixel = \"1 um\", page = 1")).stages.at(0).cells, 2);
}

TEST_F(DeckImage, PixelsAreTheIdentityOfAStudyAndItsFileIsNot) {
  const auto first = content_of(study(keys("scan.npy")));
  const std::vector<std::uint16_t> same = {7, 7, 0, 0, 7, 7, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  write("copy.npy", {4, 4}, same);
  EXPECT_EQ(content_of(study(keys("copy.npy"))), first);
  auto changed = same;
  changed[2] = 7;
  write("copy.npy", {4, 4}, changed);
  EXPECT_NE(content_of(study(keys("copy.npy"))), first);
  EXPECT_NE(content_of(study(keys("scan.npy", "pixel = \"3 um\""))), first);
  EXPECT_NE(content_of(study(keys("scan.npy", "pixel = \"2 um\", periodic = false"))), first);
  const auto read = study(keys("scan.npy"));
  EXPECT_EQ(read.provenance.file_hashes.size(), 1U);
}

TEST_F(DeckImage, MistakesInTheLabels) {
  const auto with_labels = [&](std::string_view labels) {
    return mistakes(keys("scan.npy", "pixel = \"1 um\"", labels));
  };
  EXPECT_THAT(
      with_labels(R"([{ value = 0, material = "binder" }, { value = 8, material = "hmx" }])"),
      AllOf(HasSubstr("deck.toml:14:75: stages.a.packing.labels: image: values without a label: 7 (4 pixels, 25 %)"),
            HasSubstr("image: no pixel has the value 8")));
  EXPECT_THAT(with_labels(R"([{ value = 0, material = "binder" }, { value = 7, material = "hmxx" }])"),
              HasSubstr("packing.labels.1.material: unknown material \"hmxx\", did you mean \"hmx\"?"));
  EXPECT_THAT(with_labels(R"([{ value = 0, material = "hmx" }, { value = 7, material = "hmx" }])"),
              HasSubstr("packing.labels: no label is of the matrix of the stage, \"binder\""));
  EXPECT_THAT(with_labels(R"([{ value = 0, material = "binder" }, { value = 7, material = "hmx" },
                              { value = 7, material = "binder" }])"),
              HasSubstr("the value 7 has two labels"));
  EXPECT_THAT(with_labels(R"([{ value = "0", material = "binder" }, { value = 7, material = "hmx" }])"),
              AllOf(HasSubstr("packing.labels.0.value: "), Not(HasSubstr("without a label"))));
  EXPECT_THAT(with_labels(R"([{ material = "binder" }, { value = 7.5, colour = "red" }])"),
              AllOf(HasSubstr("labels.0.value: missing, expected an integer"), HasSubstr("labels.1.value: "),
                    HasSubstr("labels.1.material: missing"), HasSubstr("unknown key \"colour\"")));
  EXPECT_THAT(with_labels("[]"), HasSubstr("packing.labels: expected at least one"));
  EXPECT_THAT(with_labels("{ value = 0, material = \"binder\" }"), HasSubstr("packing.labels: expected an array of"));
  EXPECT_THAT(mistakes("file = \"scan.npy\", pixel = \"1 um\""),
              HasSubstr("packing.labels: missing, expected an array of tables"));
}

TEST_F(DeckImage, MistakesInTheSize) {
  EXPECT_THAT(mistakes(keys("scan.npy", "pixel = 2e-6")), HasSubstr("stages.a.packing.pixel: "));
  EXPECT_THAT(mistakes(keys("scan.npy", "pixel = \"2\"")), HasSubstr("stages.a.packing.pixel: "));
  EXPECT_THAT(mistakes(keys("scan.npy", "pixel = \"0 um\"")), HasSubstr("stages.a.packing.pixel: "));
  EXPECT_THAT(mistakes(keys("scan.npy", "pixel = \"10000 km\"")), HasSubstr("packing.pixel: 4 pixels of "));
  EXPECT_THAT(mistakes(keys("scan.npy", "periodic = false")),
              HasSubstr("missing, expected the side of a pixel, such as \"2 um\", or box"));
  EXPECT_THAT(mistakes(keys("scan.npy"), "box = \"8.1 um\""),
              HasSubstr("stages.a.box: 4 pixels of 2 um are 8 um: expected that, or box or packing.pixel alone"));
  EXPECT_THAT(mistakes(keys("scan.npy"), "box = 8"), HasSubstr("stages.a.box: "));
  write("wide.npy", {3, 2}, {0, 7, 0, 7, 0, 7});
  EXPECT_THAT(
      mistakes(keys("wide.npy")),
      HasSubstr("stages.a.packing.file: expected a square image, since boxes are square, got 3 x 2 pixels; crop = { "
                "left = 0, top = 0, width = 2, height = 2 } takes a square of it"));
  write("odd.npy", {3, 3}, {0, 7, 0, 7, 0, 7, 7, 7, 7});
  EXPECT_THAT(mistakes(keys("odd.npy")), HasSubstr("stages.a.cells: missing: cells of 2 x 2 points cannot give each "
                                                   "of 3 x 3 pixels one point; cells = 3 gives each four points"));
  EXPECT_EQ(study(keys("odd.npy"), "cells = 3").stages.at(0).cells, 3);
}

TEST_F(DeckImage, MistakesInTheFile) {
  EXPECT_THAT(mistakes(keys("no.png")), HasSubstr("stages.a.packing.file: no such file: no.png"));
  EXPECT_THAT(mistakes(keys("no.h5:/labels")), HasSubstr("stages.a.packing.file: no such file: no.h5"));
  EXPECT_THAT(mistakes("pixel = \"2 um\", labels = " + std::string(two_labels)),
              HasSubstr("stages.a.packing.file: missing"));
  directory.write("text.png", "not a picture");
  EXPECT_THAT(mistakes(keys("text.png")), HasSubstr("stages.a.packing.file: text.png: "));
  const std::array<std::uint8_t, 4> pixels = {0, 1, 2, 1};
  const std::array<Rgb, 3> palette = {Rgb{0, 0, 0}, Rgb{255, 0, 0}, Rgb{9, 9, 9}};
  const auto png = encode_png(2, pixels, palette);
  directory.write("cut.png", std::string_view(png).substr(0, png.size() - 20));
  EXPECT_THAT(mistakes(keys("cut.png")), HasSubstr("stages.a.packing.file: cut.png: "));
}

TEST_F(DeckImage, OfAnotherKindThanLabels) {
  for (const auto* name : {"bad-colours.png", "bad-fraction.npy", "bad-jpeg.jpg"}) {
    directory.write(name, read_text(std::filesystem::path(BRECCIA_IMAGES_DIRECTORY) / name));
    EXPECT_THAT(mistakes(keys(name)), HasSubstr(fmt::format("stages.a.packing.file: {}: ", name)));
  }
}

TEST_F(DeckImage, MayBeADataSetOfHdf5) {
  const std::array<std::int64_t, 4> values = {0, 0, 7, 7};  // the top row first
  {
    Hdf5Writer file(directory.path() / "scan.h5");
    file.create_group("/labels");
    for (const auto* name : {"/labels/phase", "/labels/other"}) {
      file.create<std::int64_t>(name, {2, 2});
      file.write_part(name, 0, std::span<const std::int64_t>(values));
    }
    file.commit();
  }
  const auto stage = study(keys("scan.h5:/labels/phase"), "cells = 2").stages.at(0);
  EXPECT_THAT(stage.packed_by<ImagePacking<2>>()->image->labels, ElementsAre(1, 1, 0, 0)) << "from the bottom";
  EXPECT_THAT(mistakes(keys("scan.h5:/labels/phases"), "cells = 2"), HasSubstr("stages.a.packing.file: scan.h5: "));
  EXPECT_THAT(mistakes(keys("scan.h5"), "cells = 2"), HasSubstr("stages.a.packing.file: scan.h5: "));
}

TEST_F(DeckImage, WhatAnImageDoesNotHave) {
  EXPECT_THAT(mistakes(keys("scan.npy"), "filler = { material = \"hmx\" }"),
              HasSubstr("stages.a.filler: the fillers of an image are the materials of its labels: "
                        "packing.labels = [{ value = 0, material = \"...\" }, ...]"));
  EXPECT_THAT(mistakes(keys("scan.npy", "pixel = \"1 um\", walls = true, seed = 1, gap = 2")),
              AllOf(HasSubstr("an image has periodic = true or false"), HasSubstr("nothing in an image is at random"),
                    HasSubstr("unknown key \"gap\"")));
  EXPECT_THAT(mistakes(keys("scan.npy", "pixel = \"1 um\", periodic = \"yes\"")), HasSubstr("packing.periodic: "));
}

TEST_F(DeckImage, AllMistakesAreToldAtOnce) {
  EXPECT_THAT(mistakes("file = \"scan.npy\", pixel = 3, labels = [{ value = 0, material = \"bindr\" }, { value = 5, "
                       "material = \"hmx\" }], peridic = true",
                       "cells = 0"),
              AllOf(HasSubstr("packing.pixel: "), HasSubstr("unknown material \"bindr\""), HasSubstr("without a label"),
                    HasSubstr("no label is of the matrix"), HasSubstr("no pixel has the value 5"),
                    HasSubstr("unknown key \"peridic\""), HasSubstr("stages.a.cells: ")));
}

}  // namespace
}  // namespace breccia
