#include "discretisation/joined_discretisation.hpp"

#include <cmath>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include "discretisation/grain_cells.hpp"
#include "discretisation/image_cells.hpp"
#include "discretisation/labels.hpp"
#include "discretisation/mixed_cells.hpp"

namespace breccia {
namespace {

TEST(LayersOfPart, FollowOneAnother) {
  constexpr int layers = 10, parts = 4;
  int end = 0;
  for (int part = 0; part < parts; ++part) {
    const auto of_part = layers_of_part(layers, part, parts);
    EXPECT_EQ(of_part.begin, end);
    end = of_part.end;
  }
  EXPECT_EQ(end, layers);
}

TEST(LayersOfPart, AreNoneForPartsBeyondThem) {
  int all = 0;
  for (int part = 0; part < 5; ++part) {
    const auto [begin, end] = layers_of_part(3, part, 5);
    all += end - begin;
  }
  EXPECT_EQ(all, 3);
}

TEST(JoinedMixtures, AreEachOnceInTheirOrder) {
  const Mixture half = {{0, 0.5}, {1, 0.5}}, quarter = {{0, 0.25}, {1, 0.75}}, of_others = {{0, 0.5}, {2, 0.5}};
  const std::vector<std::vector<Mixture>> parts = {{half, quarter}, {}, {of_others, half}};
  const auto joined = join_mixtures(parts);
  EXPECT_EQ(joined.mixtures, (std::vector<Mixture>{half, quarter, of_others}));
  EXPECT_EQ(joined.numbers, (std::vector<std::vector<std::size_t>>{{0, 1}, {}, {2, 0}}));
}

/// The contents of the cells of a microstructure in some layers.
template <int dim>
using Filling = std::function<Discretisation<dim>(const CellLayers& layers)>;

/// Expects the cells in the parts of a microstructure to have the contents of those cells in the whole.
template <int dim>
void expect_parts_of_whole(const Filling<dim>& fill, int layers) {
  const auto whole = fill({});
  constexpr int parts = 3;
  std::size_t cells = 0;
  for (int part = 0; part < parts; ++part) {
    const auto of_part = fill(layers_of_part(layers, part, parts));
    cells += of_part.cells().size();
    const auto& [begin, end] = of_part.range();
    for_each_index(begin, end, [&](const Index<dim>& cell) {
      for (std::size_t p = 0; p < whole.cell(cell).size(); ++p) {
        const auto in_part = of_part.cell(cell)[p], in_whole = whole.cell(cell)[p];
        const auto *one = of_part.mixture(in_part), *other = whole.mixture(in_whole);
        ASSERT_EQ(one == nullptr, other == nullptr);
        if (one != nullptr) {
          ASSERT_EQ(*one, *other);
        } else {
          ASSERT_EQ(in_part, in_whole);
        }
      }
    });
  }
  EXPECT_EQ(cells, whole.cells().size());
}

const std::vector<ParticlePhases> coated = {{1, 2, 0.03}, {1, 2, 0.03}};

TEST(PartsOfDiscs, HoldTheSameCells) {
  const Microstructure<2> discs = {1.0, Walls::periodic, {{{0.05, 0.9}, 0.5}, {{0.52, 0.41}, 0.37}}};
  const std::span<const ParticlePhases> phases(coated);
  expect_parts_of_whole<2>([&](const auto& layers) { return discretise(discs, 20, 0, phases, layers); }, 20);
  expect_parts_of_whole<2>([&](const auto& layers) { return discretise_mixed(discs, 20, 0, phases, 3, layers); }, 20);
}

TEST(PartsOfSpheres, HoldTheSameCells) {
  const Microstructure<3> spheres = {1.0, Walls::periodic, {{{0.05, 0.9, 0.98}, 0.5}, {{0.52, 0.41, 0.43}, 0.37}}};
  const std::span<const ParticlePhases> phases(coated);
  expect_parts_of_whole<3>([&](const auto& layers) { return discretise(spheres, 10, 0, phases, layers); }, 10);
  expect_parts_of_whole<3>([&](const auto& layers) { return discretise_mixed(spheres, 10, 0, phases, 3, layers); }, 10);
}

TEST(PartsOfLabellings, HoldTheSameCells) {
  const auto in_wave = [](const Vector<2>& place) {
    return PhaseAt{static_cast<PhaseIndex>(std::sin(9.0 * place[0] + 7.0 * place[1]) > 0.3)};
  };
  const Grid<2> grid = {{17, 20}, 0.05};
  expect_parts_of_whole<2>([&](const auto& layers) { return discretise<2>(grid, in_wave, layers); }, 20);
  expect_parts_of_whole<2>([&](const auto& layers) { return discretise_mixed(grid, in_wave, 2, layers); }, 20);
  const auto in_layers = [](const Vector<3>& place) {
    return PhaseAt{static_cast<PhaseIndex>(std::sin(9.0 * place[0] + 7.0 * place[2]) > 0.3)};
  };
  const Grid<3> cubes = {{5, 6, 10}, 0.1};
  expect_parts_of_whole<3>([&](const auto& layers) { return discretise<3>(cubes, in_layers, layers); }, 10);
  expect_parts_of_whole<3>([&](const auto& layers) { return discretise_mixed(cubes, in_layers, 2, layers); }, 10);
}

TEST(PartsOfImages, HoldTheSameCells) {
  LabelImage<2> image = {.pixels = {7, 7}, .pixel_side = 1.0 / 7, .labels = {}};
  for (std::size_t pixel = 0; pixel < 49; ++pixel) image.labels.push_back(static_cast<Label>(pixel * pixel % 5 % 2));
  const Grid<2> grid = {{10, 10}, 0.1};
  const std::vector<PhaseIndex> phases = {0, 1};
  expect_parts_of_whole<2>([&](const auto& layers) { return discretise<2>(grid, image, phases, layers); }, 10);
  expect_parts_of_whole<2>([&](const auto& layers) { return discretise_mixed<2>(grid, image, phases, 2, layers); }, 10);
}

TEST(PartsOfGrains, HoldTheSameCells) {
  for (const auto walls : {Walls::periodic, Walls::hard}) {
    const Tessellation<3> grains({1.0, walls, {{{0.2, 0.4, 0.9}}, {{0.7, 0.3, 0.2}}, {{0.5, 0.8, 0.6}}}});
    expect_parts_of_whole<3>([&](const auto& layers) { return discretise_mixed(grains, 0.05, 10, 0, 1, 2, layers); },
                             10);
  }
}

}  // namespace
}  // namespace breccia
