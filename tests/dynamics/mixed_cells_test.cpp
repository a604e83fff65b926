// Mixed cells under the dynamic method: each is of one material, and neighbours differ.

#include "breccia/discretisation/mixed_cells.hpp"

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "breccia/checkpoint/state.hpp"
#include "breccia/discretisation/cell_shape.hpp"
#include "breccia/dynamics/dynamic_solver.hpp"

#include "block_layout.hpp"
#include "kernels.hpp"
#include "materials.hpp"
#include "maxwell_step.hpp"
#include "temporary_directory.hpp"

namespace breccia::dynamics {
namespace {

using testing_materials::relaxing;
using testing_materials::stiff;

/// A disc of material 1 in a box of material 0, with mixed cells.
DynamicProblem<2> disc_in_box(int cells, Boundary boundary) {
  constexpr std::array<PhaseIndex, 1> disc = {1};
  auto discretisation = discretise_mixed({1.0, Walls::hard, {Disc{{0.45, 0.52}, 0.61}}}, cells, 0, disc, 2);
  auto materials = with_mixtures(discretisation, {relaxing, stiff});
  DynamicProblem<2> problem{std::move(discretisation), std::move(materials)};
  problem.boundary = boundary;
  problem.load = {.xy = 0.5};
  problem.traction = {.xy = 1.0};
  return problem;
}

/// A row of cells of two phases, a mixture of them and nothing, in an order without order, under random displacements
/// that are made in one step.
class RowOfMixedCells : public testing::TestWithParam<InstructionSet> {
 protected:
  static constexpr int columns = 29, length = 40;

  RowOfMixedCells() : problem_{Discretisation<2>(Grid<2>{{columns, 1}, 1.0}), {}} {
    auto& box = problem_.discretisation;
    const auto mixture = box.add_mixture({{0, 0.375}, {1, 0.625}}, 2);
    const std::array<PhaseIndex, 4> kinds = {0, 1, mixture, no_phase};
    for (int column = 0; column < columns; ++column) box.fill({column, 0}, kinds[random_() % kinds.size()]);
    problem_.materials = with_mixtures(box, {relaxing, stiff});
    problem_.time_step = 2e-4;
    for (auto& row : values_) {
      row.assign(length, 0.0);
      for (int node = 0; node <= columns; ++node) row[static_cast<std::size_t>(node)] = uniform();
    }
  }

  /// Forces x and y of the row on the nodes of each cell, from the left and from the right: eight lists.
  [[nodiscard]] std::array<std::vector<double>, 8> forces(InstructionSet set) const {
    const BlockLayout layout(problem_, 0, 1);
    std::array<std::vector<double>, 8> f;
    for (auto& row : f) row.assign(length, 0.0);
    std::array<double, 3> stress{};
    kernels(set).cell_row_averaged({.blocks = layout.row(0),
                                    .block_count = layout.blocks_per_row(),
                                    .displacement_below = {values_[0].data(), values_[1].data()},
                                    .displacement_above = {values_[2].data(), values_[3].data()},
                                    .increment_below = {values_[0].data(), values_[1].data()},
                                    .increment_above = {values_[2].data(), values_[3].data()},
                                    .below = {f[0].data(), f[1].data(), f[2].data(), f[3].data()},
                                    .above = {f[4].data(), f[5].data(), f[6].data(), f[7].data()},
                                    .stress = stress.data()});
    return f;
  }

  /// The modulus [Pa] of a strain that was reached in the one step.
  [[nodiscard]] double after_a_step(const PronySeries& series) const {
    double modulus = series.equilibrium();
    for (const auto& [time, term] : series.terms()) {
      modulus += term * time / problem_.time_step * (1.0 - std::exp(-problem_.time_step / time));
    }
    return modulus;
  }

  double uniform() { return std::uniform_real_distribution<double>(-1.0, 1.0)(random_); }

  std::mt19937_64 random_{11};
  DynamicProblem<2> problem_;
  std::array<std::vector<double>, 4> values_;
};

TEST_P(RowOfMixedCells, HasTheForcesOfTheStiffnessOfEachCell) {
  const auto f = forces(GetParam());
  for (int column = 0; column < columns; ++column) {
    const auto c = static_cast<std::size_t>(column);
    const auto phase = problem_.discretisation.cell({column, 0}).front();
    CellShape<2>::PointModuli moduli{};
    if (phase != no_phase) {
      const auto& material = problem_.materials[phase];
      moduli.fill({.bulk = after_a_step(material.bulk), .shear = after_a_step(material.shear)});
    }
    const auto& v = values_;
    CellShape<2>::Values u, found;
    u << v[0][c], v[1][c], v[0][c + 1], v[1][c + 1], v[2][c], v[3][c], v[2][c + 1], v[3][c + 1];
    found << f[0][c], f[1][c], f[2][c + 1], f[3][c + 1], f[4][c], f[5][c], f[6][c + 1], f[7][c + 1];
    const CellShape<2>::Values expected = -CellShape<2>::stiffness(moduli, Volumetric::averaged) * u;
    EXPECT_LT((found - expected).norm(), 1e-13 * 1e8) << "in column " << column;
  }
}

TEST_P(RowOfMixedCells, HasTheSameBitsAsTheBaseline) {
  EXPECT_EQ(forces(GetParam()), forces(InstructionSet::baseline));
}

INSTANTIATE_TEST_SUITE_P(AllSets, RowOfMixedCells, testing::ValuesIn(supported_instruction_sets()),
                         [](const auto& chosen) { return std::string(name_of(chosen.param)); });

/// Averages after the load, at the same times in both formulations.
std::vector<Averages<2>> averages_of(Formulation formulation, Boundary boundary) {
  auto problem = testing_materials::with_step(disc_in_box(16, boundary), 0.4);
  problem.ramp = StrainRamp(400 * problem.time_step);
  problem.start = Start::affine;
  const auto run = make_dynamic_solver(formulation, problem);
  std::vector<Averages<2>> averages;
  run->advance(4000, averages);
  return averages;
}

TEST(MixedCells, HaveOneAnswerInBothFormulations) {
  for (const auto boundary : {Boundary::displacement, Boundary::periodic}) {
    const auto fast = averages_of(Formulation::total_lagrangian, boundary);
    const auto classical = averages_of(Formulation::classical, boundary);
    ASSERT_EQ(fast.size(), classical.size());
    // Over a thousand steps, so that the waves that are left cancel.
    double sum = 0.0, of_classical = 0.0;
    for (std::size_t i = fast.size() - 1000; i < fast.size(); ++i) {
      sum += fast[i].stress.xy;
      of_classical += classical[i].stress.xy;
    }
    EXPECT_NEAR(sum / of_classical, 1.0, 1e-3) << name_of(boundary);
  }
}

TEST(MixedCells, GoOnWithTheSameBitsOnAnotherNumberOfThreads) {
  const test::TemporaryDirectory directory;
  const auto path = directory.path() / "state.h5";
  for (const auto formulation : {Formulation::total_lagrangian, Formulation::classical}) {
    const auto solver = [&](int threads) {
      return make_dynamic_solver(formulation, testing_materials::with_step(disc_in_box(12, Boundary::traction), 0.5),
                                 threads);
    };
    const auto whole = solver(1), first = solver(2), second = solver(2);
    std::vector<Averages<2>> expected, found, before;
    whole->advance(60, before);
    whole->advance(40, expected);
    first->advance(60, before);
    StateWriter writer(path, {"deck", "version"});
    first->save(writer, "/solver");
    writer.commit();
    second->restore(StateReader(path), "/solver");
    second->advance(40, found);
    EXPECT_EQ(found, expected);
    EXPECT_EQ(second->fields().stress, whole->fields().stress);
  }
}

// A block of eight cells of different materials has the five numbers of a shear term and one of K + G/3.
TEST(MixedCells, HoldSixNumbersPerCellAndTerm) {
  const auto footprint = [](const std::vector<MaxwellTerm>& terms) {
    const Material binder{"binder", 1e3, PronySeries(1e9), PronySeries(1e6, terms)};
    Discretisation<2> box(Grid<2>{{8, 4}, 0.1});
    for (int row = 0; row < 4; ++row) {
      for (int column = 0; column < 8; ++column) {
        const double share = (1.0 + column) / 16.0;
        box.fill({column, row}, box.add_mixture({{0, share}, {1, 1.0 - share}}, 2));
      }
    }
    const auto materials = with_mixtures(box, {binder, stiff});
    return make_dynamic_solver(Formulation::total_lagrangian, testing_materials::with_step({box, materials}))
        ->footprint();
  };
  const auto without = footprint({}), with = footprint({{1.0, 1e6}, {2.0, 1e6}});
  EXPECT_EQ(with.held - without.held, 2 * 6 * sizeof(double) * 8 * 4);
}

}  // namespace
}  // namespace breccia::dynamics
