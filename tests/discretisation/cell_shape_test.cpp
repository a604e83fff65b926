#include "discretisation/cell_shape.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "test_names.hpp"

namespace breccia {
namespace {

/// Nodal values of a displacement field in a cell of side one.
template <int dim, class Field>
typename CellShape<dim>::Values nodal(Field&& field) {
  typename CellShape<dim>::Values values;
  for (int node = 0; node < CellShape<dim>::nodes; ++node) {
    Vector<dim> place{};
    const auto corner = CellShape<dim>::corner(node);
    for (std::size_t axis = 0; axis < place.size(); ++axis) place[axis] = corner[axis];
    const Vector<dim> u = field(place);
    for (int i = 0; i < dim; ++i) values[dim * node + i] = u[static_cast<std::size_t>(i)];
  }
  return values;
}

constexpr Moduli soft = {3.0, 0.7}, stiff = {40.0, 20.0};

/// The moduli of points that are soft and stiff in turn.
template <int dim>
typename CellShape<dim>::PointModuli mixed_moduli() {
  typename CellShape<dim>::PointModuli moduli{};
  for (std::size_t p = 0; p < moduli.size(); ++p) moduli[p] = p % 3 == 0 ? soft : stiff;
  return moduli;
}

template <int dim>
typename CellShape<dim>::PointModuli uniform_moduli(const Moduli& of_all) {
  typename CellShape<dim>::PointModuli moduli{};
  moduli.fill(of_all);
  return moduli;
}

/// Tests for two and three dimensions.
template <class Dimension>
class CellShapeOf : public testing::Test {};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(CellShapeOf, Dimensions, breccia::test::DimensionNames);

TYPED_TEST(CellShapeOf, WeightsSumToOneAndReproduceThePositionOfThePoint) {
  constexpr int dim = TypeParam::value;
  using Shape = CellShape<dim>;
  for (int p = 0; p < Shape::points; ++p) {
    const auto weights = Shape::weights(p);
    double total = 0.0;
    Vector<dim> position{};
    for (int node = 0; node < Shape::nodes; ++node) {
      const double weight = weights[static_cast<std::size_t>(node)];
      total += weight;
      for (std::size_t axis = 0; axis < position.size(); ++axis) position[axis] += weight * Shape::corner(node)[axis];
    }
    EXPECT_DOUBLE_EQ(total, 1.0);
    for (std::size_t axis = 0; axis < position.size(); ++axis) {
      EXPECT_DOUBLE_EQ(position[axis], 0.5 + Shape::offset(p)[axis]);
      EXPECT_DOUBLE_EQ(std::abs(Shape::offset(p)[axis]), 0.25);
    }
    EXPECT_DOUBLE_EQ(weights[static_cast<std::size_t>(p)], std::pow(0.75, dim)) << "the node next to the point";
  }
  EXPECT_DOUBLE_EQ(Shape::points * Shape::point_volume, 1.0);
}

/// The patch test: every point of a cell reproduces a uniform strain, and its stress does the right work.
TYPED_TEST(CellShapeOf, UniformStrainIsExact) {
  constexpr int dim = TypeParam::value;
  using Shape = CellShape<dim>;
  for (int place = 0; place < Shape::strains; ++place) {
    Strain<dim> strain;
    component(strain, place) = place < dim ? 1.0 : 0.5;
    const auto u = Shape::affine_motion(strain);
    for (const auto volumetric : {Volumetric::averaged, Volumetric::standard}) {
      for (int p = 0; p < Shape::points; ++p) {
        const typename Shape::StrainVector seen = Shape::strain_matrix(p, volumetric) * u;
        EXPECT_TRUE(seen.isApprox(Shape::StrainVector::Unit(place), 1e-14)) << seen;
      }
      // Uniaxial strain: lambda + 2 G = K + 4 G / 3 in any dimension; engineering shear: G.
      const double modulus = place < dim ? soft.bulk + 4.0 / 3.0 * soft.shear : soft.shear;
      EXPECT_NEAR(u.dot(Shape::stiffness(uniform_moduli<dim>(soft), volumetric) * u), modulus, 1e-13);
    }
  }
}

TYPED_TEST(CellShapeOf, RigidMotionsTakeNoForceAndAllElseDoes) {
  constexpr int dim = TypeParam::value;
  using Shape = CellShape<dim>;
  constexpr int rigid_motions = dim + dim * (dim - 1) / 2;
  for (const auto volumetric : {Volumetric::averaged, Volumetric::standard}) {
    const auto stiffness = Shape::stiffness(mixed_moduli<dim>(), volumetric);
    EXPECT_TRUE(stiffness.isApprox(stiffness.transpose()));
    for (std::size_t i = 0; i < dim; ++i) {
      const auto translation = nodal<dim>([&](const Vector<dim>&) {
        Vector<dim> u{};
        u[i] = 1.0;
        return u;
      });
      EXPECT_LT((stiffness * translation).norm(), 1e-13);
      for (std::size_t j = 0; j < i; ++j) {
        const auto rotation = nodal<dim>([&](const Vector<dim>& x) {
          Vector<dim> u{};
          u[i] = x[j];
          u[j] = -x[i];
          return u;
        });
        EXPECT_LT((stiffness * rotation).norm(), 2e-13);
      }
    }
    const auto eigenvalues = Eigen::SelfAdjointEigenSolver<typename Shape::Stiffness>(stiffness).eigenvalues();
    EXPECT_LT(std::abs(eigenvalues[rigid_motions - 1]), 1e-12);
    EXPECT_GT(eigenvalues[rigid_motions], 0.01);
  }
}

TYPED_TEST(CellShapeOf, AveragedStrainKeepsTheDeviatorAndHasTheMeanDilatation) {
  constexpr int dim = TypeParam::value;
  using Shape = CellShape<dim>;
  // u_x = x y: the volumetric strain is y, 1/2 in the mean of the cell.
  const auto hourglass = nodal<dim>([](const Vector<dim>& x) {
    Vector<dim> u{};
    u[0] = x[0] * x[1];
    return u;
  });
  for (int p = 0; p < Shape::points; ++p) {
    const typename Shape::StrainVector own = Shape::strain_matrix(p) * hourglass;
    const typename Shape::StrainVector seen = Shape::strain_matrix(p, Volumetric::averaged) * hourglass;
    EXPECT_NEAR(seen[0] - seen[1], own[0] - own[1], 1e-15);
    EXPECT_DOUBLE_EQ(own.template head<dim>().sum(), 0.5 + Shape::offset(p)[1]);
    EXPECT_DOUBLE_EQ(seen.template head<dim>().sum(), 0.5);
    EXPECT_EQ(seen.template tail<Shape::strains - dim>(), own.template tail<Shape::strains - dim>());
    EXPECT_DOUBLE_EQ(Shape::volumetric_strain_matrix(p, Volumetric::averaged).dot(hourglass), 0.5);
    EXPECT_DOUBLE_EQ(Shape::volumetric_strain_matrix(p, Volumetric::standard).dot(hourglass),
                     0.5 + Shape::offset(p)[1]);
    EXPECT_EQ(Shape::strain_matrix(p, Volumetric::standard), Shape::strain_matrix(p));
  }
}

TEST(CellShape2D, StrainOfABilinearFieldIsExactAtThePoints) {
  const auto hourglass = nodal<2>([](const Vector<2>& x) { return Vector<2>{x[0] * x[1], 0.0}; });
  for (int p = 0; p < CellShape<2>::points; ++p) {
    const auto [x, y] = CellShape<2>::offset(p);
    EXPECT_TRUE((CellShape<2>::strain_matrix(p) * hourglass).isApprox(Eigen::Vector3d(0.5 + y, 0.0, 0.5 + x)));
  }
}

TEST(CellShape2D, EnergyOfPlaneStrain) {
  const auto dilation = nodal<2>([](const Vector<2>& x) { return x; });
  const auto stiffness = CellShape<2>::stiffness(uniform_moduli<2>(soft), Volumetric::averaged);
  EXPECT_NEAR(dilation.dot(stiffness * dilation), 4.0 * (soft.bulk + soft.shear / 3.0), 1e-13);
}

TEST(CellShape3D, EnergyOfADilatationIsThatOfTheBulkModulusAlone) {
  const auto dilation = nodal<3>([](const Vector<3>& x) { return x; });
  const auto stiffness = CellShape<3>::stiffness(uniform_moduli<3>(soft), Volumetric::averaged);
  EXPECT_NEAR(dilation.dot(stiffness * dilation), 9.0 * soft.bulk, 1e-12);
}

TEST(CellShape3D, ShearsStandInVoigtsOrder) {
  // u_x = z is an engineering shear zx, the fifth component.
  const auto shear = nodal<3>([](const Vector<3>& x) { return Vector<3>{x[2], 0.0, 0.0}; });
  const CellShape<3>::StrainVector seen = CellShape<3>::strain_matrix(5) * shear;
  EXPECT_TRUE(seen.isApprox(CellShape<3>::StrainVector::Unit(4)));
}

TEST(CellShape2D, AveragedPointsDoNotResistAnIncompressibleHourglass) {
  const auto moduli = uniform_moduli<2>({1e9, 1.0});
  const CellShape<2>::Values pure = nodal<2>([](const Vector<2>& x) {
    return Vector<2>{x[0] * x[1] - 0.5 * (x[0] + x[1]), 0.0};
  });
  const auto energy = [&](Volumetric volumetric) {
    return pure.dot(CellShape<2>::stiffness(moduli, volumetric) * pure);
  };
  // By Eq. 7 of the theory F_u = q / 2, of which a quarter does work on q = 1.
  EXPECT_NEAR(energy(Volumetric::averaged), 1.0 / 8.0, 1e-6);
  EXPECT_GT(energy(Volumetric::standard), 1e7);
}

}  // namespace
}  // namespace breccia
