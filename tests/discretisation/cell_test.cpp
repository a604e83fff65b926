#include "breccia/discretisation/cell.hpp"

#include <gtest/gtest.h>

namespace breccia {
namespace {

constexpr std::array<Vector<2>, 4> nodes = {{{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}}};

/// Nodal values of a displacement field in a cell of side one.
template <class Field>
CellVector nodal(Field&& field) {
  CellVector values;
  for (std::size_t node = 0; node < 4; ++node) {
    const Vector<2> u = field(nodes[node]);
    values.segment<2>(static_cast<Eigen::Index>(2 * node)) << u[0], u[1];
  }
  return values;
}

const auto stretch_x = nodal([](const Vector<2>& x) { return Vector<2>{x[0], 0.0}; });
const auto simple_shear = nodal([](const Vector<2>& x) { return Vector<2>{x[1], 0.0}; });
const auto dilation = nodal([](const Vector<2>& x) { return Vector<2>{x[0], x[1]}; });
const auto hourglass = nodal([](const Vector<2>& x) { return Vector<2>{x[0] * x[1], 0.0}; });

TEST(Cell, WeightsReproduceThePositionOfThePoint) {
  for (int p = 0; p < points_per_cell; ++p) {
    const auto weights = node_weights(p);
    double total = 0.0, x = 0.0, y = 0.0;
    for (std::size_t node = 0; node < 4; ++node) {
      total += weights[node];
      x += weights[node] * nodes[node][0];
      y += weights[node] * nodes[node][1];
    }
    EXPECT_DOUBLE_EQ(total, 1.0);
    EXPECT_DOUBLE_EQ(x, 0.5 + point_offsets[static_cast<std::size_t>(p)][0]);
    EXPECT_DOUBLE_EQ(y, 0.5 + point_offsets[static_cast<std::size_t>(p)][1]);
  }
}

TEST(Cell, StrainIsExactForLinearAndBilinearFields) {
  for (int p = 0; p < points_per_cell; ++p) {
    EXPECT_TRUE((strain_matrix(p) * stretch_x).isApprox(Eigen::Vector3d(1.0, 0.0, 0.0)));
    EXPECT_TRUE((strain_matrix(p) * simple_shear).isApprox(Eigen::Vector3d(0.0, 0.0, 1.0)));
    const auto& [x, y] = point_offsets[static_cast<std::size_t>(p)];
    EXPECT_TRUE((strain_matrix(p) * hourglass).isApprox(Eigen::Vector3d(0.5 + y, 0.0, 0.5 + x)));
  }
}

TEST(Cell, AveragedStrainKeepsTheDeviatorOfThePoint) {
  for (int p = 0; p < points_per_cell; ++p) {
    const Eigen::Vector3d own = strain_matrix(p) * hourglass;
    const Eigen::Vector3d seen = strain_matrix(p, Volumetric::averaged) * hourglass;
    EXPECT_DOUBLE_EQ(seen[0] - seen[1], own[0] - own[1]);
    EXPECT_DOUBLE_EQ(seen[2], own[2]);
    EXPECT_DOUBLE_EQ(seen[0] + seen[1], 0.5);
    EXPECT_EQ(strain_matrix(p, Volumetric::standard), strain_matrix(p));
  }
}

TEST(Cell, AveragedVolumetricStrainIsThatOfTheCentre) {
  for (int p = 0; p < points_per_cell; ++p) {
    EXPECT_DOUBLE_EQ(volumetric_strain_matrix(p, Volumetric::averaged).dot(hourglass), 0.5);
    EXPECT_DOUBLE_EQ(volumetric_strain_matrix(p, Volumetric::averaged).dot(dilation), 2.0);
    EXPECT_DOUBLE_EQ(volumetric_strain_matrix(p, Volumetric::standard).dot(hourglass),
                     0.5 + point_offsets[static_cast<std::size_t>(p)][1]);
  }
}

class CellStiffness : public testing::TestWithParam<Volumetric> {
 protected:
  static constexpr Moduli soft = {3.0, 0.7}, stiff = {40.0, 20.0};
  const CellMatrix uniform = cell_stiffness({soft, soft, soft, soft}, GetParam());
  const CellMatrix mixed = cell_stiffness({soft, stiff, stiff, soft}, GetParam());
};

TEST_P(CellStiffness, EnergyOfUniformStrainIsExact) {
  const double lambda = soft.bulk - 2.0 / 3.0 * soft.shear;
  EXPECT_NEAR(stretch_x.dot(uniform * stretch_x), lambda + 2.0 * soft.shear, 1e-13);
  EXPECT_NEAR(simple_shear.dot(uniform * simple_shear), soft.shear, 1e-14);
  EXPECT_NEAR(dilation.dot(uniform * dilation), 4.0 * (soft.bulk + soft.shear / 3.0), 1e-13);
}

TEST_P(CellStiffness, RigidMotionTakesNoForce) {
  const auto translation = nodal([](const Vector<2>&) { return Vector<2>{1.0, -2.0}; });
  const auto rotation = nodal([](const Vector<2>& x) { return Vector<2>{-x[1], x[0]}; });
  EXPECT_LT((mixed * translation).norm(), 1e-13);
  EXPECT_LT((mixed * rotation).norm(), 1e-13);
}

TEST_P(CellStiffness, IsSymmetricAndPositiveOnTheFiveStrainModes) {
  EXPECT_TRUE(mixed.isApprox(mixed.transpose()));
  const auto eigenvalues = Eigen::SelfAdjointEigenSolver<CellMatrix>(mixed).eigenvalues();
  EXPECT_LT(std::abs(eigenvalues[2]), 1e-13);
  EXPECT_GT(eigenvalues[3], 0.01);
}

INSTANTIATE_TEST_SUITE_P(BothOptions, CellStiffness, testing::Values(Volumetric::averaged, Volumetric::standard));

TEST(Cell, AveragedPointsDoNotResistAnIncompressibleHourglass) {
  const Moduli incompressible = {1e9, 1.0};
  const CellVector pure = hourglass - nodal([](const Vector<2>& x) { return Vector<2>{0.5 * (x[0] + x[1]), 0.0}; });
  const auto energy = [&](Volumetric volumetric) {
    return pure.dot(cell_stiffness({incompressible, incompressible, incompressible, incompressible}, volumetric) *
                    pure);
  };
  // Theory, Eq. 7: F_u = q / 2, and a quarter of it works on q = 1.
  EXPECT_NEAR(energy(Volumetric::averaged), 1.0 / 8.0, 1e-6);
  EXPECT_GT(energy(Volumetric::standard), 1e7);
}

}  // namespace
}  // namespace breccia
