#include <array>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "discretisation/cell_shape.hpp"
#include "dynamics/block_layout.hpp"
#include "dynamics/kernels.hpp"
#include "materials.hpp"

namespace breccia::dynamics {
namespace {

using testing_materials::soft;
using testing_materials::stiff;

struct Case {
  InstructionSet set;
  Volumetric volumetric;
};

/// One row of cells with a random mixture of two materials and holes, and random nodal displacements.
class CellRowKernel : public testing::TestWithParam<Case> {
 protected:
  static constexpr int columns = 21, length = 32;

  CellRowKernel() : problem_{Discretisation<2>(Grid<2>{{columns, 1}, 1.0}), {soft, stiff}} {
    auto& random = random_;
    problem_.volumetric = GetParam().volumetric;
    problem_.time_step = 1e-6;
    problem_.discretisation.paint([&](const Vector<2>& point) { return point[0] > 8.0 && uniform(random) > 0.0; }, 1);
    problem_.discretisation.paint([&](const Vector<2>& point) { return point[0] > 8.0 && uniform(random) > 0.6; },
                                  no_phase);
    for (auto& row : values_) {
      row.assign(length, 0.0);
      for (int node = 0; node <= columns; ++node) row[static_cast<std::size_t>(node)] = uniform(random);
    }
    for (auto& row : forces_) row.assign(length, 0.0);
  }

  void run(InstructionSet set) {
    const BlockLayout<2> layout(problem_, 0, 1);
    const NodeValues<2> below = {{values_[0].data(), values_[1].data()}};
    const NodeValues<2> above = {{values_[2].data(), values_[3].data()}};
    const CellRow<2> row = {
        .blocks = layout.row(0, 0),
        .block_count = layout.blocks_per_row(),
        .displacement = {below, above},
        .increment = {below, above},
        .force = {{{forces_[0].data(), forces_[1].data()}}, {{forces_[2].data(), forces_[3].data()}}},
        .stress = stress_.data()};
    const auto& table = kernels<2>(set);
    (problem_.volumetric == Volumetric::averaged ? table.cell_row_averaged : table.cell_row_standard)(row);
  }

  [[nodiscard]] CellShape<2>::Values displacement(std::size_t column) const {
    const auto& v = values_;
    CellShape<2>::Values u;
    u << v[0][column], v[1][column], v[0][column + 1], v[1][column + 1], v[2][column], v[3][column], v[2][column + 1],
        v[3][column + 1];
    return u;
  }
  /// Adds the forces of a cell to those of its nodes.
  static void add(const CellShape<2>::Values& force, std::size_t column, std::array<std::vector<double>, 4>& nodes) {
    for (std::size_t i = 0; i < 4; ++i) {
      const auto left = static_cast<Eigen::Index>(i < 2 ? i : i + 2);
      nodes[i][column] += force[left];
      nodes[i][column + 1] += force[left + 2];
    }
  }

  static double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-52 - 1.0; }

  std::mt19937_64 random_{7};
  DynamicProblem<2> problem_;
  std::array<std::vector<double>, 4> values_;
  std::array<std::vector<double>, 4> forces_;  ///< x and y on the nodes below, then on those above
  std::array<double, 3> stress_{};
};

TEST_P(CellRowKernel, GivesTheForcesOfTheCellStiffness) {
  run(GetParam().set);
  Eigen::Vector3d stress = Eigen::Vector3d::Zero();
  std::array<std::vector<double>, 4> expected;
  for (auto& along : expected) along.assign(length, 0.0);
  for (int column = 0; column < columns; ++column) {
    CellShape<2>::PointModuli moduli{};
    for (int p = 0; p < CellShape<2>::points; ++p) {
      const auto material = problem_.discretisation.cell({column, 0})[static_cast<std::size_t>(p)];
      if (material == no_phase) continue;
      const auto& [bulk, shear] = moduli[static_cast<std::size_t>(p)] = {
          problem_.materials[material].bulk.equilibrium(), problem_.materials[material].shear.equilibrium()};
      const CellShape<2>::Values u = displacement(static_cast<std::size_t>(column));
      const Eigen::Vector3d e = CellShape<2>::strain_matrix(p, problem_.volumetric) * u;
      const double pressure = bulk * (e[0] + e[1]);
      stress += Eigen::Vector3d(pressure + shear * (4 * e[0] - 2 * e[1]) / 3,
                                pressure + shear * (4 * e[1] - 2 * e[0]) / 3, shear * e[2]);
    }
    const auto c = static_cast<std::size_t>(column);
    add(-CellShape<2>::stiffness(moduli, problem_.volumetric) * displacement(c), c, expected);
  }
  for (std::size_t i = 0; i < expected.size(); ++i) {
    for (std::size_t node = 0; node < length; ++node) {
      EXPECT_NEAR(forces_[i][node], expected[i][node], 1e-13 * 1e8) << "at node " << node;
    }
  }
  for (Eigen::Index i = 0; i < 3; ++i) EXPECT_NEAR(stress_[static_cast<std::size_t>(i)], stress[i], 1e-13 * 1e9);
}

TEST_P(CellRowKernel, GivesTheSameBitsAsTheBaseline) {
  run(InstructionSet::baseline);
  const auto forces = forces_;
  const auto stress = stress_;
  run(GetParam().set);
  EXPECT_EQ(forces_, forces);
  EXPECT_EQ(stress_, stress);
}

std::vector<Case> all_cases() {
  std::vector<Case> cases;
  for (const auto set : supported_instruction_sets()) {
    for (const auto volumetric : {Volumetric::averaged, Volumetric::standard}) cases.push_back({set, volumetric});
  }
  return cases;
}

INSTANTIATE_TEST_SUITE_P(AllSets, CellRowKernel, testing::ValuesIn(all_cases()), [](const auto& chosen) {
  return std::string(name_of(chosen.param.set)) +
         (chosen.param.volumetric == Volumetric::averaged ? "Averaged" : "Standard");
});

}  // namespace
}  // namespace breccia::dynamics
