// Tests of mixed cells under the dynamic method: each cell has one material, which differs from that of its neighbours.

#include "discretisation/mixed_cells.hpp"

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "checkpoint/state.hpp"
#include "discretisation/cell_shape.hpp"
#include "dynamics/block_layout.hpp"
#include "dynamics/dynamic_solver.hpp"
#include "dynamics/kernels.hpp"
#include "materials.hpp"
#include "temporary_directory.hpp"

namespace breccia::dynamics {
namespace {

using testing_materials::relaxing;
using testing_materials::stiff;

/// A disc of material 1 in a box of material 0, with mixed cells.
DynamicProblem<2> disc_in_box(int cells, Boundary boundary) {
  constexpr std::array<PhaseIndex, 1> disc = {1};
  auto discretisation = discretise_mixed<2>({1.0, Walls::hard, {Disc{{0.45, 0.52}, 0.61}}}, cells, 0, disc, 2);
  auto materials = with_mixtures(discretisation, {relaxing, stiff});
  DynamicProblem<2> problem{std::move(discretisation), std::move(materials)};
  problem.boundary = boundary;
  problem.load = {.xy = 0.5};
  problem.traction = {.xy = 1.0};
  return problem;
}

/// A row of cells of two phases, of a mixture of them and of no phase, in an irregular order, under random
/// displacements that are reached in one step.
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

  /// Components x and y on the nodes below the row, then on those above.
  using Values = std::array<std::vector<double>, 4>;

  [[nodiscard]] Values forces(InstructionSet set) const { return forces(set, BlockLayout<2>(problem_, 0, 1), values_); }

  /// The sums of the forces of the cells on their nodes, after increments of the displacements.
  [[nodiscard]] Values forces(InstructionSet set, const BlockLayout<2>& layout, const Values& increments) const {
    auto f = no_forces();
    std::array<double, 3> stress{};
    const NodeValues<2> below = {{values_[0].data(), values_[1].data()}};
    const NodeValues<2> above = {{values_[2].data(), values_[3].data()}};
    const NodeValues<2> increment_below = {{increments[0].data(), increments[1].data()}};
    const NodeValues<2> increment_above = {{increments[2].data(), increments[3].data()}};
    kernels<2>(set).cell_row_averaged({.blocks = layout.row(0, 0),
                                       .block_count = layout.blocks_per_row(),
                                       .displacement = {below, above},
                                       .increment = {increment_below, increment_above},
                                       .force = {{{f[0].data(), f[1].data()}}, {{f[2].data(), f[3].data()}}},
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

  /// The displacements of the nodes of a cell.
  [[nodiscard]] static CellShape<2>::Values of_cell(const Values& v, std::size_t c) {
    CellShape<2>::Values u;
    u << v[0][c], v[1][c], v[0][c + 1], v[1][c + 1], v[2][c], v[3][c], v[2][c + 1], v[3][c + 1];
    return u;
  }
  /// Adds the forces of a cell to those of its nodes.
  static void add(const CellShape<2>::Values& force, std::size_t c, Values& nodes) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const auto left = static_cast<Eigen::Index>(i < 2 ? i : i + 2);
      nodes[i][c] += force[left];
      nodes[i][c + 1] += force[left + 2];
    }
  }
  [[nodiscard]] static Values no_forces() {
    Values none;
    for (auto& row : none) row.assign(length, 0.0);
    return none;
  }
  static void expect_near(const Values& found, const Values& expected, double tolerance) {
    for (std::size_t i = 0; i < expected.size(); ++i) {
      for (std::size_t node = 0; node <= columns; ++node) {
        EXPECT_NEAR(found[i][node], expected[i][node], tolerance) << "at node " << node;
      }
    }
  }
  [[nodiscard]] PhaseIndex phase_of(std::size_t column) const {
    return problem_.discretisation.cell({static_cast<int>(column), 0}).front();
  }

  double uniform() { return std::uniform_real_distribution<double>(-1.0, 1.0)(random_); }

  std::mt19937_64 random_{11};
  DynamicProblem<2> problem_;
  Values values_;
};

TEST_P(RowOfMixedCells, HasTheForcesOfTheStiffnessOfEachCell) {
  auto expected = no_forces();
  for (std::size_t column = 0; column < columns; ++column) {
    const auto phase = phase_of(column);
    CellShape<2>::PointModuli moduli{};
    if (phase != no_phase) {
      const auto& material = problem_.materials[phase];
      moduli.fill({.bulk = after_a_step(material.bulk), .shear = after_a_step(material.shear)});
    }
    add(-CellShape<2>::stiffness(moduli, Volumetric::averaged) * of_cell(values_, column), column, expected);
  }
  expect_near(forces(GetParam()), expected, 1e-13 * 1e8);
}

/// A modulus applied to displacements u that change in steps: M u plus the sum of the stresses of its Maxwell terms,
/// each of which decays over a step and grows with the increment (theory, Eq. 10).
struct Hereditary {
  explicit Hereditary(PronySeries modulus) : series(std::move(modulus)), terms(series.terms().size()) {
    for (auto& term : terms) term.setZero();
  }
  void add(const CellShape<2>::Values& increment, double step) {
    total += increment;
    for (std::size_t k = 0; k < terms.size(); ++k) {
      const auto& [time, modulus] = series.terms()[k];
      const double decay = std::exp(-step / time);
      terms[k] = decay * terms[k] + modulus * time / step * (1.0 - decay) * increment;
    }
  }
  [[nodiscard]] CellShape<2>::Values of_terms() const {
    CellShape<2>::Values sum = CellShape<2>::Values::Zero();
    for (const auto& term : terms) sum += term;
    return sum;
  }
  [[nodiscard]] CellShape<2>::Values value() const { return series.equilibrium() * total + of_terms(); }

  PronySeries series;
  std::vector<CellShape<2>::Values> terms;
  CellShape<2>::Values total = CellShape<2>::Values::Zero();
};

TEST_P(RowOfMixedCells, RemembersEarlierSteps) {
  CellShape<2>::PointModuli unit_shear{}, unit_bulk{};
  unit_shear.fill({.bulk = 0.0, .shear = 1.0});
  unit_bulk.fill({.bulk = 1.0, .shear = 0.0});
  const auto of_shear = CellShape<2>::stiffness(unit_shear, Volumetric::averaged);
  const auto of_bulk = CellShape<2>::stiffness(unit_bulk, Volumetric::averaged);
  std::vector<Hereditary> shear, bulk;
  for (std::size_t column = 0; column < columns; ++column) {
    const auto phase = phase_of(column);
    shear.emplace_back(phase == no_phase ? PronySeries() : problem_.materials[phase].shear);
    bulk.emplace_back(phase == no_phase ? PronySeries() : problem_.materials[phase].bulk);
  }
  const BlockLayout<2> layout(problem_, 0, 1);
  auto increments = values_;
  for (auto& row : values_) row.assign(length, 0.0);
  Values f;
  for (int step = 0; step < 3; ++step) {
    for (std::size_t row = 0; row < 4; ++row) {
      for (std::size_t node = 0; node <= columns; ++node) values_[row][node] += increments[row][node] = uniform();
    }
    f = forces(GetParam(), layout, increments);
    for (std::size_t column = 0; column < columns; ++column) {
      shear[column].add(of_cell(increments, column), problem_.time_step);
      bulk[column].add(of_cell(increments, column), problem_.time_step);
    }
  }
  auto expected = no_forces();
  for (std::size_t column = 0; column < columns; ++column) {
    add(-of_shear * shear[column].value() - of_bulk * bulk[column].value(), column, expected);
    if (phase_of(column) == no_phase) continue;
    // The histories from which the stresses of points are computed (theory, Eq. 6).
    const auto found = layout.histories({static_cast<int>(column), 0}, phase_of(column));
    const auto along_x = [](const CellShape<2>::Values& u) { return 0.5 * ((u[2] - u[0]) + (u[6] - u[4])); };
    const auto along_y = [](const CellShape<2>::Values& u) { return 0.5 * ((u[5] - u[1]) + (u[7] - u[3])); };
    const auto of_terms = shear[column].of_terms(), volume = bulk[column].of_terms();
    EXPECT_NEAR(found.shear[0], along_x(of_terms), 1e-6);
    EXPECT_NEAR(found.shear[1], along_y(of_terms), 1e-6);
    EXPECT_NEAR(found.shear[3], (of_terms[6] - of_terms[4]) - (of_terms[2] - of_terms[0]), 1e-6);
    EXPECT_NEAR(found.bulk[0], along_x(volume) + along_y(volume), 1e-6);
  }
  expect_near(f, expected, 1e-12 * 1e8);
}

TEST_P(RowOfMixedCells, HasTheSameBitsAsTheBaseline) {
  EXPECT_EQ(forces(GetParam()), forces(InstructionSet::baseline));
}

INSTANTIATE_TEST_SUITE_P(AllSets, RowOfMixedCells, testing::ValuesIn(supported_instruction_sets()),
                         [](const auto& chosen) { return std::string(name_of(chosen.param)); });

/// Averages after the load, at the same times in both formulations.
std::vector<Averages<2>> averages_of(Formulation formulation, Boundary boundary, const Strain<2>& load) {
  auto problem = testing_materials::with_step(disc_in_box(16, boundary), 0.4);
  problem.load = load;
  problem.ramp = StrainRamp(400 * problem.time_step);
  problem.start = Start::affine;
  const auto run = make_dynamic_solver(formulation, problem);
  std::vector<Averages<2>> averages;
  run->advance(4000, averages);
  return averages;
}

TEST(MixedCells, HaveOneAnswerInBothFormulations) {
  constexpr Strain<2> shear = {.xy = 0.5}, bulk = {.xx = 0.5, .yy = 0.5};
  for (const auto& [boundary, load] :
       {std::pair(Boundary::displacement, shear), {Boundary::periodic, shear}, {Boundary::displacement, bulk}}) {
    const auto fast = averages_of(Formulation::total_lagrangian, boundary, load);
    const auto classical = averages_of(Formulation::classical, boundary, load);
    ASSERT_EQ(fast.size(), classical.size());
    // The sums are over a thousand steps, so that the remaining waves cancel.
    double sum = 0.0, of_classical = 0.0;
    for (std::size_t i = fast.size() - 1000; i < fast.size(); ++i) {
      sum += fast[i].stress.xy + fast[i].stress.xx;
      of_classical += classical[i].stress.xy + classical[i].stress.xx;
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

TEST(MixedCells, AreRefusedWithStandardStrains) {
  auto problem = testing_materials::with_step(disc_in_box(12, Boundary::displacement));
  problem.volumetric = Volumetric::standard;
  EXPECT_THROW(make_dynamic_solver(Formulation::total_lagrangian, problem), InputError);
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
    return make_dynamic_solver(Formulation::total_lagrangian, testing_materials::with_step<2>({box, materials}))
        ->footprint();
  };
  const auto without = footprint({}), with = footprint({{1.0, 1e6}, {2.0, 1e6}});
  EXPECT_EQ(with.held - without.held, 2 * 6 * sizeof(double) * 8 * 4);
}

}  // namespace
}  // namespace breccia::dynamics
