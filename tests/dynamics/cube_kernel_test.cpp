// Tests of the forces of cubic cells against the stiffness of each cell.
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "discretisation/cell_shape.hpp"
#include "dynamics/layer_step.hpp"
#include "materials.hpp"

namespace breccia::dynamics {
namespace {

using testing_materials::relaxing;
using testing_materials::soft;
using testing_materials::stiff;

using Shape = CellShape<3>;

struct CubeCase {
  InstructionSet set;
  Volumetric volumetric;
};

/// The effective modulus [Pa] for a strain that was reached in one step.
double after_a_step(const PronySeries& series, double step) {
  double modulus = series.equilibrium();
  for (const auto& [time, term] : series.terms()) modulus += term * time / step * (1.0 - std::exp(-step / time));
  return modulus;
}

/// Two planes of cells with random nodal displacements that came in one step.
class LayersOfCubes : public testing::TestWithParam<CubeCase> {
 protected:
  static constexpr Index<3> cells = {21, 3, 2};
  static constexpr double side = 0.125;

  LayersOfCubes() : problem_{Discretisation<3>(Grid<3>{cells, side}), {relaxing, stiff, soft}} {
    problem_.volumetric = GetParam().volumetric;
    problem_.time_step = 2e-4;
    displacements_.resize(problem_.discretisation.grid().node_count());
    for (auto& u : displacements_) u = {uniform(), uniform(), uniform()};
  }

  /// Fills the left part with whole cells, and the right part with points of two materials and of none.
  void mix_points() {
    problem_.discretisation.paint([&](const Vector<3>& x) { return x[0] > 1.0 && uniform() > 0.0; }, 1);
    problem_.discretisation.paint([&](const Vector<3>& x) { return x[0] > 1.0 && uniform() > 0.6; }, no_phase);
  }

  /// Fills the layers with cells of one material each, in an irregular order.
  void mix_cells() {
    auto& box = problem_.discretisation;
    const auto mixture = box.add_mixture({{0, 0.375}, {1, 0.625}}, 3);
    const std::array<PhaseIndex, 4> kinds = {0, 1, mixture, no_phase};
    box.grid().for_each_cell([&](const Index<3>& cell) { box.fill(cell, kinds[random_() % kinds.size()]); });
    problem_.materials = with_mixtures(box, problem_.materials);
  }

  /// Sums of the forces on the nodes over the cell side, and the mean stress.
  struct Found {
    std::vector<Vector<3>> forces;
    std::array<double, 6> stress = {};
  };

  [[nodiscard]] Found found(InstructionSet set) const {
    const auto& grid = problem_.discretisation.grid();
    LayerStep<3> step(problem_, set, 0, cells[2]);
    auto& nodes = step.nodes();
    grid.for_each_node([&](const Index<3>& node) {
      const int row = nodes.row_of(node);
      for (std::size_t i = 0; i < 3; ++i) {
        const double u = displacements_[grid.node_index(node)][i];
        nodes.displacement(row)[i][node[0]] = u;
        nodes.increment(row)[i][node[0]] = u;
      }
    });
    Found found;
    found.forces.resize(grid.node_count());
    LayerSums<3> sums(grid);
    for (int layer = 0; layer < cells[2]; ++layer) {
      ForceLayer<3> below(nodes.layer_size()), above(nodes.layer_size());
      step.find_forces(layer, below.view(), above.view(), sums, 0);
      const std::array<LayerForces<3>, 2> sides = {below.view(), above.view()};
      for (int upper = 0; upper < 2; ++upper) {
        for_each_index(
            Index<3>{0, 0, layer + upper}, Index<3>{cells[0] + 1, cells[1] + 1, layer + upper + 1},
            [&](const Index<3>& node) {
              const auto index = static_cast<std::size_t>(node[1]) * nodes.stride() + static_cast<std::size_t>(node[0]);
              for (std::size_t i = 0; i < 3; ++i) {
                found.forces[grid.node_index(node)][i] += sides[static_cast<std::size_t>(upper)].of_axis[i][index];
              }
            });
      }
      for (std::size_t i = 0; i < 6; ++i) found.stress[i] += sums.of(layer, 0).stress[i];
    }
    return found;
  }

  [[nodiscard]] Shape::Values displacements_of(const Index<3>& cell) const {
    Shape::Values u;
    for (int n = 0; n < Shape::nodes; ++n) {
      const auto& of_node = displacements_[node_index(cell, n)];
      for (int i = 0; i < 3; ++i) u[3 * n + i] = of_node[static_cast<std::size_t>(i)];
    }
    return u;
  }

  [[nodiscard]] std::size_t node_index(const Index<3>& cell, int n) const {
    auto node = Shape::corner(n);
    for (std::size_t axis = 0; axis < 3; ++axis) node[axis] += cell[axis];
    return problem_.discretisation.grid().node_index(node);
  }

  /// The expected sums, from the stiffness of the cells and the strains of their points.
  [[nodiscard]] Found expected() const {
    const auto& grid = problem_.discretisation.grid();
    Found expected;
    expected.forces.resize(grid.node_count());
    grid.for_each_cell([&](const Index<3>& cell) {
      Shape::PointModuli moduli{};
      const auto u = displacements_of(cell);
      for (int p = 0; p < Shape::points; ++p) {
        const auto phase = problem_.discretisation.cell(cell)[static_cast<std::size_t>(p)];
        if (phase == no_phase) continue;
        const auto& material = problem_.materials[phase];
        const Moduli of_point = {after_a_step(material.bulk, problem_.time_step),
                                 after_a_step(material.shear, problem_.time_step)};
        moduli[static_cast<std::size_t>(p)] = of_point;
        const Shape::StrainVector e = Shape::strain_matrix(p, problem_.volumetric) * u;
        const double trace = e[0] + e[1] + e[2];
        for (int i = 0; i < 6; ++i) {
          const double deviator = i < 3 ? 2.0 * of_point.shear * (e[i] - trace / 3.0) : of_point.shear * e[i];
          expected.stress[static_cast<std::size_t>(i)] += (i < 3 ? of_point.bulk * trace : 0.0) + deviator;
        }
      }
      const Shape::Values forces = -Shape::stiffness(moduli, problem_.volumetric) * u;
      for (int n = 0; n < Shape::nodes; ++n) {
        for (int i = 0; i < 3; ++i) {
          expected.forces[node_index(cell, n)][static_cast<std::size_t>(i)] += forces[3 * n + i];
        }
      }
    });
    return expected;
  }

  void expect_forces_of_the_stiffness() const {
    const auto right = expected(), is = found(GetParam().set);
    for (std::size_t node = 0; node < right.forces.size(); ++node) {
      for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(is.forces[node][i], right.forces[node][i], 1e-13 * 1e9);
    }
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(is.stress[i], right.stress[i], 1e-13 * 1e11);
  }

  double uniform() { return std::uniform_real_distribution<double>(-1.0, 1.0)(random_); }

  std::mt19937_64 random_{5};
  DynamicProblem<3> problem_;
  std::vector<Vector<3>> displacements_;
};

TEST_P(LayersOfCubes, OfPointsHaveTheForcesOfTheirStiffness) {
  mix_points();
  expect_forces_of_the_stiffness();
}

/// Tests of mixed cells, which have averaged volumetric strains.
class LayersOfMixedCubes : public LayersOfCubes {};

TEST_P(LayersOfMixedCubes, HaveTheForcesOfTheirStiffness) {
  mix_cells();
  expect_forces_of_the_stiffness();
}

TEST_P(LayersOfCubes, GiveTheSameBitsAsTheBaseline) {
  mix_points();
  const auto baseline = found(InstructionSet::baseline), is = found(GetParam().set);
  EXPECT_EQ(is.forces, baseline.forces);
  EXPECT_EQ(is.stress, baseline.stress);
}

std::vector<CubeCase> cube_cases(const std::vector<Volumetric>& choices) {
  std::vector<CubeCase> cases;
  for (const auto set : supported_instruction_sets()) {
    for (const auto volumetric : choices) cases.push_back({set, volumetric});
  }
  return cases;
}

constexpr auto by_case = [](const auto& chosen) {
  return fmt::format("{}_{}", name_of(chosen.param.set), name_of(chosen.param.volumetric));
};
INSTANTIATE_TEST_SUITE_P(AllSets, LayersOfCubes,
                         testing::ValuesIn(cube_cases({Volumetric::averaged, Volumetric::standard})), by_case);
INSTANTIATE_TEST_SUITE_P(AllSets, LayersOfMixedCubes, testing::ValuesIn(cube_cases({Volumetric::averaged})), by_case);

}  // namespace
}  // namespace breccia::dynamics
