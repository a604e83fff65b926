#include "quasistatic/operator/elastic_operator.hpp"

#include <array>
#include <cmath>
#include <set>
#include <tuple>
#include <type_traits>
#include <vector>

#include <gtest/gtest.h>

#include "composites.hpp"
#include "discretisation/mixed_cells.hpp"
#include "quasistatic/operator/cube_forces.hpp"
#include "quasistatic/operator/square_forces.hpp"
#include "quasistatic/operator/vector_values.hpp"
#include "test_names.hpp"

namespace breccia::quasistatic {
namespace {

/// Every cell has materials of its own.
Discretisation<2> of_different_cells(int side, int materials) {
  const Grid<2> grid = {{side, side}, 1.0};
  Discretisation<2> discretisation(grid);
  for (int material = 1; material < materials; ++material) {
    discretisation.paint(
        [&](const Vector<2>& position) {
          const int column = static_cast<int>(position[0]), row = static_cast<int>(position[1]);
          const bool right = position[0] - column > 0.5, upper = position[1] - row > 0.5;
          auto number = grid.cell_index({column, row});
          for (int point = 0; point < (right ? 1 : 0) + (upper ? 2 : 0); ++point) {
            number /= static_cast<std::size_t>(materials);
          }
          return static_cast<int>(number % static_cast<std::size_t>(materials)) == material;
        },
        static_cast<PhaseIndex>(material));
  }
  return discretisation;
}

/// Tests for two and three dimensions.
template <class Dimension>
class ElasticOperatorOf : public testing::Test {};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(ElasticOperatorOf, Dimensions, breccia::test::DimensionNames);

/// A discretisation of one material with different numbers of cells along the axes.
template <int dim>
Discretisation<dim> homogeneous() {
  Grid<dim> grid{.cell_side = 1e-3};
  for (std::size_t axis = 0; axis < dim; ++axis) grid.cells[axis] = 3 + static_cast<int>(axis);
  return Discretisation<dim>(grid);
}

constexpr Moduli of_all = {3.0, 0.7};

template <int dim>
double modulus_under(Load load) {
  if (load != Load::bulk) return of_all.shear;
  return dim == 2 ? of_all.bulk + of_all.shear / 3.0 : of_all.bulk;
}

/// The patch test of the traction boundary: K u = M f with the uniform strain u and the modulus M of the load, whatever
/// components are held against rigid motions.
TYPED_TEST(ElasticOperatorOf, UniformStrainIsInEquilibriumWithTheTraction) {
  constexpr int dim = TypeParam::value;
  const ElasticOperator<dim> elastic_operator(homogeneous<dim>(), Volumetric::averaged, Boundary::traction);
  for (const auto load : {Load::shear, Load::diagonal_shear, Load::bulk}) {
    const auto strain = elastic_operator.uniform_strain(load);
    auto difference = forces_under(elastic_operator, std::array{of_all}, strain, unit_strain<dim>(load));
    const double modulus = modulus_under<dim>(load);
    EXPECT_NEAR(work(difference, strain), modulus * elastic_operator.volume(), 1e-11);
    difference.add(-modulus, elastic_operator.load_forces(load));
    difference.set_macroscopic(0.0);  // the macroscopic part is undefined here
    EXPECT_LT(std::sqrt(work(difference, difference)), 1e-12);
  }
}

/// A homogeneous body under the affine motion of a load has no forces on its nodes, and its energy is that of its
/// modulus.
TYPED_TEST(ElasticOperatorOf, AffineMotionLeavesNoNodalForce) {
  constexpr int dim = TypeParam::value;
  for (const auto boundary : {Boundary::displacement, Boundary::periodic}) {
    const ElasticOperator<dim> elastic_operator(homogeneous<dim>(), Volumetric::averaged, boundary);
    for (const auto load : {Load::shear, Load::diagonal_shear, Load::bulk}) {
      auto forces = forces_under(elastic_operator, std::array{of_all}, elastic_operator.uniform_strain(load),
                                 unit_strain<dim>(load));
      EXPECT_NEAR(forces.macroscopic(), modulus_under<dim>(load) * elastic_operator.volume(), 1e-11);
      forces.set_macroscopic(0.0);
      EXPECT_LT(std::sqrt(work(forces, forces)), 1e-12);
    }
  }
}

TYPED_TEST(ElasticOperatorOf, HoldsAsManyComponentsAsThereAreRigidMotions) {
  constexpr int dim = TypeParam::value;
  const auto held = [](Boundary boundary) {
    const ElasticOperator<dim> elastic_operator(homogeneous<dim>(), Volumetric::averaged, boundary);
    auto nodes = elastic_operator.grid().nodes();
    if (boundary == Boundary::periodic) nodes = elastic_operator.grid().cells;
    int count = 0;
    for_each_index(Index<dim>{}, nodes, [&](const Index<dim>& node) {
      for (int component = 0; component < dim; ++component) count += elastic_operator.is_held(node, component) ? 1 : 0;
    });
    return count;
  };
  EXPECT_EQ(held(Boundary::traction), dim * (dim + 1) / 2);
  EXPECT_EQ(held(Boundary::periodic), dim);
  // All nodes except those inside are held: 20 - 6 of 4 x 5 nodes, 120 - 24 of 4 x 5 x 6 nodes.
  EXPECT_EQ(held(Boundary::displacement), dim == 2 ? 2 * 14 : 3 * 96);
}

TEST(ElasticOperator, HasTheSameForcesInSpaceForAnyNumberOfThreads) {
  const Microstructure<3> box = {1.0, Walls::hard, {{{0.47, 0.52, 0.55}, 0.6}}};
  constexpr std::array<PhaseIndex, 1> of_sphere = {1};
  const std::vector<Moduli> moduli = {{.bulk = 3.0, .shear = 1.0}, {.bulk = 40.0, .shear = 30.0}};
  const auto bits = [](Vec vector) {
    PetscInt size = 0;
    check(VecGetLocalSize(vector, &size), "reading the size of a vector");
    const ReadValues values(vector);
    return std::vector<double>(values.data(), values.data() + size);
  };
  for (const auto boundary : test::boundaries) {
    for (const int cells : {5, 11, 12}) {
      const auto forces_of = [&](int threads) {
        const ElasticOperator<3> elastic_operator(discretise_mixed(box, cells, 0, of_sphere, 2), Volumetric::averaged,
                                                  boundary, threads);
        auto moved = elastic_operator.uniform_strain(Load::shear);
        const auto once = forces_under(elastic_operator, moduli, moved, unit_strain<3>(Load::shear));
        moved.add(0.1, once);
        const auto forces = forces_under(elastic_operator, moduli, moved, unit_strain<3>(Load::shear));
        return std::tuple(forces.macroscopic(), bits(forces.fluctuation()), bits(forces.phase_strains()));
      };
      const auto expected = forces_of(1);
      for (const int threads : {2, 3}) EXPECT_EQ(forces_of(threads), expected) << name_of(boundary) << ", " << cells;
    }
  }
}

TEST(ElasticOperator, TellsMoreThan65536KindsOfCellsApart) {
  constexpr int side = 257, materials = 17;
  const ElasticOperator<2> elastic_operator(of_different_cells(side, materials), Volumetric::averaged,
                                            Boundary::displacement);
  std::set<std::size_t> kinds;
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) kinds.insert(elastic_operator.kinds().of({column, row}));
  }
  EXPECT_EQ(kinds.size(), static_cast<std::size_t>(side) * side);
}

}  // namespace
}  // namespace breccia::quasistatic
