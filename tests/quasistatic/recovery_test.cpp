#include "quasistatic/operator/recovery.hpp"

#include <array>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace breccia::quasistatic {
namespace {

const Grid<2> grid = {{4, 3}, 0.5};

/// A displacement whose fluctuation is a function of the node's coordinates in units of the cell side.
Displacement with_fluctuation(const ElasticOperator<2>& elastic_operator,
                              const std::function<std::array<double, 2>(double, double)>& fluctuation) {
  auto displacement = elastic_operator.zero();
  double* values = nullptr;
  check(VecGetArray(displacement.fluctuation(), &values), "writing");
  for (int row = 0; row <= grid.rows(); ++row) {
    for (int column = 0; column <= grid.columns(); ++column) {
      const auto [x, y] = fluctuation(column, row);
      values[2 * grid.node_index({column, row})] = x;
      values[2 * grid.node_index({column, row}) + 1] = y;
    }
  }
  check(VecRestoreArray(displacement.fluctuation(), &values), "writing");
  return displacement;
}

std::map<PhaseIndex, AppliedModuli> elastic(const Displacement& displacement, const std::vector<Moduli>& moduli) {
  std::map<PhaseIndex, AppliedModuli> applied;
  for (const auto& [bulk, shear] : moduli) {
    AppliedModuli of_phase = {displacement.copy(), displacement.copy()};
    of_phase.bulk.scale(bulk);
    of_phase.shear.scale(shear);
    applied.emplace(static_cast<PhaseIndex>(applied.size()), std::move(of_phase));
  }
  return applied;
}

// The test checks Hooke's law in plane strain and the affine motion of the points.
TEST(RecoverFields, OfAUniformStrainAreUniform) {
  Discretisation<2> discretisation(grid);
  discretisation.paint([](const Vector<2>& position) { return position[0] < 1.0; }, 1);
  const std::vector<Moduli> moduli = {{.bulk = 5.0, .shear = 3.0}, {.bulk = 20.0, .shear = 0.5}};
  for (const auto load : {Load::shear, Load::diagonal_shear, Load::bulk}) {
    for (const auto volumetric : {Volumetric::averaged, Volumetric::standard}) {
      const ElasticOperator<2> elastic_operator(discretisation, volumetric, Boundary::displacement);
      const auto displacement = elastic_operator.uniform_strain(load);
      const auto fields = recover_fields(elastic_operator, discretisation, volumetric, load, displacement,
                                         elastic(displacement, moduli));
      const auto [xx, yy, xy] = unit_strain<2>(load);
      for (int row = 0; row < grid.rows(); ++row) {
        for (int column = 0; column < grid.columns(); ++column) {
          for (int p = 0; p < CellShape<2>::points; ++p) {
            const auto point = grid.point_index({column, row}, p);
            const auto position = discretisation.position({column, row}, p);
            const auto& [bulk, shear] = moduli[fields.phase[point]];
            EXPECT_EQ(fields.phase[point], position[0] < 1.0 ? 1 : 0);
            EXPECT_NEAR(fields.displacement[point][0], xx * position[0] + xy * position[1], 1e-14);
            EXPECT_NEAR(fields.displacement[point][1], xy * position[0] + yy * position[1], 1e-14);
            const double mean = (xx + yy) / 3.0;
            const std::array strain = {xx, yy, xy};
            const std::array stress = {bulk * 3.0 * mean + 2.0 * shear * (xx - mean),
                                       bulk * 3.0 * mean + 2.0 * shear * (yy - mean),
                                       bulk * 3.0 * mean - 2.0 * shear * mean, 2.0 * shear * xy};
            for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(fields.strain[point].at(k), strain.at(k), 1e-14);
            for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(fields.stress[point].at(k), stress.at(k), 1e-13);
          }
        }
      }
    }
  }
}

// The bilinear displacement u_x = x y has the strain xx = y, xy = x / 2, which B-bar replaces by its mean over the cell
// in the volumetric part alone.
TEST(RecoverFields, OfABilinearDisplacementHaveItsStrainAtThePoints) {
  const Discretisation<2> discretisation(grid);
  for (const auto volumetric : {Volumetric::averaged, Volumetric::standard}) {
    const ElasticOperator<2> elastic_operator(discretisation, volumetric, Boundary::traction);
    const auto displacement = with_fluctuation(elastic_operator, [](double x, double y) {
      return std::array{x * y, 0.0};
    });
    const auto fields = recover_fields(elastic_operator, discretisation, volumetric, Load::shear, displacement,
                                       elastic(displacement, {{.bulk = 2.0, .shear = 0.0}}));
    for (int row = 0; row < grid.rows(); ++row) {
      for (int column = 0; column < grid.columns(); ++column) {
        for (int p = 0; p < CellShape<2>::points; ++p) {
          const auto point = grid.point_index({column, row}, p);
          const auto position = discretisation.position({column, row}, p);
          const double x = position[0] / grid.cell_side, y = position[1] / grid.cell_side;
          const double volume = volumetric == Volumetric::averaged ? row + 0.5 : y;
          EXPECT_NEAR(fields.displacement[point][0], grid.cell_side * x * y, 1e-13);
          EXPECT_NEAR(fields.strain[point][0], y + 0.5 * (volume - y), 1e-13);
          EXPECT_NEAR(fields.strain[point][1], 0.5 * (volume - y), 1e-13);
          EXPECT_NEAR(fields.strain[point][2], 0.5 * x, 1e-13);
          EXPECT_NEAR(fields.stress[point][2], 2.0 * volume, 1e-13);
        }
      }
    }
  }
}

TEST(RecoverFields, OfAPeriodicBoxJoinItsSides) {
  // One node has moved; in a periodic box it is the node in all four corners.
  const Discretisation<2> discretisation(grid);
  const ElasticOperator<2> elastic_operator(discretisation, Volumetric::standard, Boundary::periodic);
  auto displacement = elastic_operator.zero();
  double* values = nullptr;
  check(VecGetArray(displacement.fluctuation(), &values), "writing");
  values[0] = 1.0;
  check(VecRestoreArray(displacement.fluctuation(), &values), "writing");
  const auto fields = recover_fields(elastic_operator, discretisation, Volumetric::standard, Load::shear, displacement,
                                     elastic(displacement, {{.bulk = 1.0, .shear = 1.0}}));
  const auto moved = [&](int column, int row, int p) {
    return fields.displacement[grid.point_index({column, row}, p)][0] / grid.cell_side;
  };
  EXPECT_DOUBLE_EQ(moved(0, 0, 0), 9.0 / 16.0);
  EXPECT_DOUBLE_EQ(moved(3, 0, 1), 9.0 / 16.0);
  EXPECT_DOUBLE_EQ(moved(0, 2, 2), 9.0 / 16.0);
  EXPECT_DOUBLE_EQ(moved(3, 2, 3), 9.0 / 16.0);
  EXPECT_DOUBLE_EQ(moved(1, 1, 0), 0.0);
}

// The test checks Hooke's law in three dimensions. The cells of the first layer have one phase; half of the points of
// the second layer have another.
TEST(RecoverFields, OfACubeAreMeansOverItsCells) {
  const Grid<3> cube = {{2, 2, 2}, 0.5};
  Discretisation<3> discretisation(cube);
  discretisation.paint([](const Vector<3>& position) { return position[2] > 0.75; }, 1);
  const std::vector<Moduli> moduli = {{.bulk = 5.0, .shear = 3.0}, {.bulk = 20.0, .shear = 0.5}};
  constexpr std::array loads = {Load::shear,          Load::shear_yz,          Load::shear_zx,
                                Load::diagonal_shear, Load::diagonal_shear_yz, Load::bulk};
  for (const auto load : loads) {
    const ElasticOperator<3> elastic_operator(discretisation, Volumetric::averaged, Boundary::displacement);
    const auto displacement = elastic_operator.uniform_strain(load);
    const auto fields = recover_fields(elastic_operator, discretisation, Volumetric::averaged, load, displacement,
                                       elastic(displacement, moduli));
    ASSERT_EQ(fields.strain.size(), cube.cell_count());
    const auto strain = unit_strain<3>(load);
    const double trace = strain.xx + strain.yy + strain.zz;
    cube.for_each_cell([&](const Index<3>& cell) {
      const auto index = cube.cell_index(cell);
      const bool is_mixed = cell[2] == 1;
      const double bulk = is_mixed ? 12.5 : 5.0, shear = is_mixed ? 1.75 : 3.0;
      Vector<3> centre{};
      for (std::size_t axis = 0; axis < 3; ++axis) centre[axis] = 0.5 * (cell[axis] + 0.5);
      const auto moved = product(strain, centre);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(fields.displacement[index].at(axis), moved[axis], 1e-14);
      }
      for (int k = 0; k < 6; ++k) {
        const double pressure = k < 3 ? (bulk - 2.0 / 3.0 * shear) * trace : 0.0;
        const auto i = static_cast<std::size_t>(k);
        EXPECT_NEAR(fields.strain[index].at(i), component(strain, k), 1e-14) << name_of(load) << " " << k;
        EXPECT_NEAR(fields.stress[index].at(i), pressure + 2.0 * shear * component(strain, k), 1e-13)
            << name_of(load) << " " << k;
      }
    });
  }
}

}  // namespace
}  // namespace breccia::quasistatic
