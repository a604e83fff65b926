// Tests of the cells of stages whose particles are crystals.
#include "homogenisation/box/stage_cells.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "homogenisation/box/crystal_orientations.hpp"
#include "homogenisation/run/test_requests.hpp"
#include "study/two_stages.hpp"

namespace breccia {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double side = 1e-3;

/// Three discs, of which the first and the last are crystals of an orthorhombic material.
class CellsOfAStage : public testing::Test {
 protected:
  CellsOfAStage() {
    Filler hmx;
    hmx.material = {"hmx", 1900.0, PronySeries(14e9), PronySeries(6e9)};
    ElasticConstants constants{};
    const std::array diagonal = {25e9, 22e9, 30e9, 9e9, 6e9, 4e9};
    for (std::size_t i = 1; i <= diagonal.size(); ++i) constants[place_of_constant(i, i)] = diagonal[i - 1];
    constants[place_of_constant(1, 2)] = 10e9;
    constants[place_of_constant(1, 3)] = 12e9;
    constants[place_of_constant(2, 3)] = 8e9;
    hmx.crystal = Crystal{constants, ListedOrientations{"angles.csv", {{0.3, 0.0, 0.0}, {0.2, 1.1, 0.7}}}};
    Filler glass;
    glass.material = test::glass;
    stage = {.name = "box",
             .matrix = test::binder,
             .side = side,
             .cells = 20,
             .fillers = {hmx, glass},
             .packing = ExplicitPacking<2>{}};
    packed.box = Box<2>(discs);
    study.tests.field_times = {study.tests.first_time};
    study.stages = {stage};
  }

  const Microstructure<2> discs = {
      side,
      Walls::periodic,
      {{{0.25e-3, 0.25e-3}, 0.36e-3}, {{0.75e-3, 0.3e-3}, 0.3e-3}, {{0.5e-3, 0.72e-3}, 0.4e-3}},
      {0, 1, 0}};
  Stage stage;
  StageMicrostructure packed;
  Study study = test::two_stages();
};

TEST_F(CellsOfAStage, HaveTheStiffnessOfTheirParticle) {
  const auto& angles = std::get<ListedOrientations>(stage.fillers[0].crystal->orientations).angles;
  const auto filler = phases_of(stage).index_of("hmx"), glass = phases_of(stage).index_of("glass");
  for (const auto mixing : {Mixing::series, Mixing::points}) {
    const auto cells = cells_of(stage, packed, discretise(stage, packed, 20, mixing));
    const auto& points = std::get<Discretisation<2>>(cells.discretisation);
    const auto phase_in = [&](std::size_t particle) {
      const auto& centre = discs.particles[particle].centre;
      return points.cell({static_cast<int>(20.0 * centre[0] / side), static_cast<int>(20.0 * centre[1] / side)})[0];
    };
    EXPECT_EQ(cells.crystals.size(), 2u);
    EXPECT_EQ(phase_in(1), glass);
    for (const std::size_t particle : {0u, 2u}) {
      const auto& found = cells.crystals.at(phase_in(particle));
      EXPECT_EQ(found.stiffness, crystal_stiffness(*stage.fillers[0].crystal, angles[particle / 2]));
      EXPECT_EQ(found.shown_as, filler);
    }
  }
}

TEST_F(CellsOfAStage, KeepTheFractionsOfTheirFillers) {
  const auto before = discretise(stage, packed, 20, Mixing::series);
  const auto cells = cells_of(stage, packed, before);
  const auto phases = phases_of(stage).size();
  auto found = fractions(cells.discretisation, phases + 2);
  const auto expected = fractions(before, phases);
  const auto filler = phases_of(stage).index_of("hmx");
  EXPECT_LT(found[filler], 0.1) << "mixed cells alone have the isotropic means";
  for (const auto& [phase, crystal] : cells.crystals) found[crystal.shown_as] += found[phase];
  for (std::size_t phase = 0; phase < phases; ++phase) EXPECT_NEAR(found[phase], expected[phase], 1e-12);
}

// The mean stress under a unit shear is the modulus, whichever crystal carries it.
TEST_F(CellsOfAStage, HaveFieldsWhoseMeanStressIsTheModulus) {
  for (const auto mixing : {Mixing::series, Mixing::points}) {
    for (const auto solver : {Solver::reduced, Solver::stepping}) {
      study.tests.quasistatic.solver = solver;
      const auto cells = cells_of(stage, packed, discretise(stage, packed, 20, mixing));
      const auto result =
          run_quasistatic_test(make_quasistatic_test(study, stage, test::binder, cells, Boundary::periodic, 1));
      const auto& fields = std::get<GridFields<2>>(result.fields).at_times.front().fields;
      double stress = 0.0;
      for (const auto& at : fields.stress) stress += at[3] / static_cast<double>(fields.stress.size());
      EXPECT_NEAR(stress / result.responses.front().modulus.front().modulus, 1.0, 1e-6);
      EXPECT_LT(*std::ranges::max_element(fields.phase), phases_of(stage).size());
    }
  }
}

// Orientations are drawn from the seed of the packing and the number of the filler.
TEST_F(CellsOfAStage, HaveOtherOrientationsForEachSeedAndFiller) {
  stage.fillers[1].crystal = stage.fillers[0].crystal;
  std::set<double> first_angles;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    for (std::size_t filler = 0; filler < 2; ++filler) {
      stage.fillers[filler].crystal->orientations = RandomOrientations{seed};
      first_angles.insert(crystal_orientations(stage, filler, 1).front().phi1);
    }
  }
  EXPECT_EQ(first_angles.size(), 40u);
}

TEST_F(CellsOfAStage, ExpectAnOrientationForEachCrystal) {
  std::get<ListedOrientations>(stage.fillers[0].crystal->orientations).angles.pop_back();
  EXPECT_THAT([&] { static_cast<void>(cells_of(stage, packed, discretise(stage, packed, 20, Mixing::series))); },
              ThrowsMessage<InputError>(HasSubstr("filler of hmx: orientations: angles.csv: expected those of 2 "
                                                  "particles, got 1")));
}

}  // namespace
}  // namespace breccia
