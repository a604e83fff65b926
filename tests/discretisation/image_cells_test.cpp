#include "discretisation/image_cells.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "discretisation/mixed_cells.hpp"

namespace breccia {
namespace {

using testing::ElementsAre;

const std::vector<PhaseIndex> same_phases = {0, 1, 2};

/// A random image of three labels, whose side does not depend on the number of pixels.
LabelImage<2> random_image(int pixels) {
  LabelImage<2> image = {{pixels, pixels}, 3.0 / pixels, Walls::hard, {}};
  std::mt19937 random(7);  // NOLINT(cert-msc32-c,cert-msc51-cpp): the same in every run
  for (int pixel = 0; pixel < pixels * pixels; ++pixel) image.labels.push_back(static_cast<Label>(random() % 3));
  return image;
}

Grid<2> grid_of(int cells) {
  return {{cells, cells}, 3.0 / cells};
}

TEST(ImageCells, PointsHaveThePhaseOfTheirPixel) {
  for (const int pixels : {1, 3, 8, 13, 40}) {
    const auto image = random_image(pixels);
    // With these numbers of cells no point is on the border of two pixels, where rounding would decide.
    for (const int cells : {3, 5, 11}) {
      if (2 * pixels % (4 * cells) == 0 || pixels % 4 == 0) continue;
      const auto labelled = discretise(grid_of(cells), image, same_phases);
      labelled.grid().for_each_cell([&](const Index<2>& cell) {
        for (int point = 0; point < 4; ++point) {
          EXPECT_EQ(labelled.cell(cell)[static_cast<std::size_t>(point)],
                    image.label_at(labelled.position(cell, point)))
              << pixels << " pixels, " << cells << " cells";
        }
      });
    }
  }
}

TEST(ImageCells, GiveEachOfTwicePixelsOnePoint) {
  const auto labelled = discretise(grid_of(2),
                                   {{4, 4},
                                    0.75,
                                    Walls::hard,
                                    {0, 1, 2, 0,  //
                                     1, 1, 0, 0,  //
                                     2, 2, 0, 1,  //
                                     0, 2, 1, 1}},
                                   same_phases);
  EXPECT_THAT(labelled.cell({0, 0}), ElementsAre(0, 1, 1, 1));
  EXPECT_THAT(labelled.cell({1, 0}), ElementsAre(2, 0, 0, 0));
  EXPECT_THAT(labelled.cell({0, 1}), ElementsAre(2, 2, 0, 2));
}

TEST(ImageCells, APointBetweenPixelsIsInThatOfTheGreaterCoordinate) {
  // The points of a cell of 4 x 4 pixels are in the corners of pixels.
  const auto labelled = discretise(Grid<2>{{1, 1}, 3.0},
                                   LabelImage<2>{{4, 4},
                                                 0.75,
                                                 Walls::hard,
                                                 {0, 0, 0, 0,  //
                                                  0, 1, 0, 2,  //
                                                  0, 0, 0, 0,  //
                                                  0, 2, 0, 1}},
                                   same_phases);
  EXPECT_THAT(labelled.cell({0, 0}), ElementsAre(1, 2, 2, 1));
}

/// Share of a cell that a label has, from 400 x 400 samples.
double sampled_share(const LabelImage<2>& image, const Grid<2>& grid, const Index<2>& cell, Label label) {
  constexpr int samples = 400;
  int inside = 0;
  for (int row = 0; row < samples; ++row) {
    for (int column = 0; column < samples; ++column) {
      const Vector<2> place = {(cell[0] + (column + 0.5) / samples) * grid.cell_side,
                               (cell[1] + (row + 0.5) / samples) * grid.cell_side};
      inside += image.label_at(place) == label ? 1 : 0;
    }
  }
  return static_cast<double>(inside) / (samples * samples);
}

TEST(ImageCells, MixturesHaveTheAreasOfThePixels) {
  for (const int pixels : {4, 6, 7, 15}) {
    const auto image = random_image(pixels);
    const auto grid = grid_of(6);
    const auto mixed = discretise_mixed(grid, image, same_phases, 3);
    grid.for_each_cell([&](const Index<2>& cell) {
      const auto number = mixed.cell(cell).front();
      const auto* mixture = mixed.mixture(number);
      double sum = 0.0;
      for (PhaseIndex phase = 0; phase < 3; ++phase) {
        double share = number == phase ? 1.0 : 0.0;
        if (mixture != nullptr) {
          const auto part = std::ranges::find(*mixture, phase, [](const auto& one) { return one.phase; });
          share = part == mixture->end() ? 0.0 : part->fraction;
        }
        sum += share;
        // The tolerance is half a step for the rounding to steps, twice that where the largest part has the rest, and 1
        // % for the samples.
        EXPECT_NEAR(share, sampled_share(image, grid, cell, phase), 1.0 / mixture_steps + 0.01);
      }
      EXPECT_DOUBLE_EQ(sum, 1.0);
    });
  }
}

TEST(ImageCells, OfWholePixelsHaveNoMixtures) {
  const auto image = random_image(6);
  for (const int cells : {6, 12}) {
    const auto mixed = discretise_mixed(grid_of(cells), image, same_phases, 3);
    EXPECT_TRUE(mixed.mixtures().empty());
    EXPECT_TRUE(std::ranges::equal(mixed.cells(), discretise(grid_of(cells), image, same_phases).cells()));
  }
}

TEST(ImageCells, LabelsHavePhases) {
  const auto image = random_image(4);
  const std::vector<PhaseIndex> two = {0, 1}, other = {0, 1, 7};
  EXPECT_THROW(static_cast<void>(discretise(grid_of(4), image, two)), InputError);
  EXPECT_THROW(static_cast<void>(discretise_mixed(grid_of(4), image, other, 3)), InputError);
  const std::vector<PhaseIndex> merged = {0, 1, 1};
  EXPECT_EQ(discretise(grid_of(4), image, merged).fractions(2)[1],
            discretise(grid_of(4), image, same_phases).fractions(3)[1] +
                discretise(grid_of(4), image, same_phases).fractions(3)[2]);
}

}  // namespace
}  // namespace breccia
