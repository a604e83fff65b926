// Tests of composites with anisotropic phases against exact solutions.
#include "breccia/discretisation/crystals.hpp"

#include <array>
#include <cstddef>
#include <map>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/quasistatic/apparent_moduli.hpp"

#include "composites.hpp"
#include "quasistatic/operator/recovery.hpp"

namespace breccia {
namespace {

using Matrix6 = StiffnessTensor<3>;

constexpr Moduli binder = {.bulk = 3.0, .shear = 1.0};

/// A triclinic crystal: all of its 21 components are different, and shears are coupled to normal strains.
Matrix6 triclinic() {
  Matrix6 stiffness;
  stiffness << 30.0, 9.0, 11.0, 1.0, -2.0, 0.5,  //
      9.0, 25.0, 8.0, -1.5, 0.7, 2.2,            //
      11.0, 8.0, 41.0, 0.3, 1.1, -0.8,           //
      1.0, -1.5, 0.3, 7.0, 0.4, -0.6,            //
      -2.0, 0.7, 1.1, 0.4, 9.0, 1.2,             //
      0.5, 2.2, -0.8, -0.6, 1.2, 12.0;
  return stiffness;
}

/// Layers of two solids across an axis, the first with this share of the volume: its effective stiffness where the
/// strains in the layers (`in`) are those of the whole, and the stresses across them (`across`) too.
template <int dim>
StiffnessTensor<dim> laminate(const StiffnessTensor<dim>& first, const StiffnessTensor<dim>& second, double share,
                              const std::vector<int>& in, const std::vector<int>& across) {
  const auto block = [](const StiffnessTensor<dim>& c, const std::vector<int>& rows, const std::vector<int>& columns) {
    return Eigen::MatrixXd(c(rows, columns));
  };
  const auto mean = [&](const auto& of) -> Eigen::MatrixXd { return share * of(first) + (1.0 - share) * of(second); };
  const Eigen::MatrixXd compliance = mean([&](const auto& c) { return block(c, across, across).inverse().eval(); });
  const Eigen::MatrixXd coupling =
      mean([&](const auto& c) { return (block(c, across, across).inverse() * block(c, across, in)).eval(); });
  const Eigen::MatrixXd relaxed = mean([&](const auto& c) {
    return (block(c, in, in) - block(c, in, across) * block(c, across, across).inverse() * block(c, across, in)).eval();
  });
  const Eigen::MatrixXd a = compliance.inverse();
  StiffnessTensor<dim> effective;
  effective(across, across) = a;
  effective(across, in) = a * coupling;
  effective(in, across) = (a * coupling).transpose();
  effective(in, in) = relaxed + coupling.transpose() * a * coupling;
  return effective;
}

/// Stress under the unit strain of a load, as the modulus of the load.
template <int dim>
double modulus_under(Load load, const StiffnessTensor<dim>& stiffness) {
  const auto strain = engineering_strain<dim>(unit_strain<dim>(load));
  return strain.dot(stiffness * strain);
}

/// A stiffness in space whose part in plane strain is given.
Matrix6 in_space(const StiffnessTensor<2>& in_plane) {
  Matrix6 stiffness = Matrix6::Identity();
  stiffness(strain_components<2>, strain_components<2>) = in_plane;
  return stiffness;
}

Material elastic(const Moduli& moduli) {
  return {"solid", 1000.0, PronySeries(moduli.bulk), PronySeries(moduli.shear)};
}

/// Four layers across the last axis, one of them of the binder.
template <int dim>
QuasistaticProblem<dim> layers_of(const Matrix6& crystal, LinearMethod method) {
  Index<dim> cells;
  cells.fill(4);
  QuasistaticProblem<dim> problem = {.discretisation = Discretisation<dim>(Grid<dim>{cells, 1.0}),
                                     .materials = {elastic(binder), elastic({.bulk = 1.0, .shear = 1.0})},
                                     .boundary = Boundary::periodic,
                                     .linear = {.method = method, .threads = 1},
                                     .crystals = {{1, {crystal}}}};
  problem.discretisation.paint([](const Vector<dim>& x) { return x.back() > 1.0; }, 1);
  return problem;
}

TEST(Crystals, InLayersOfSpaceHaveTheExactStiffness) {
  const auto exact = laminate<3>(isotropic_stiffness<3>(binder), triclinic(), 0.25, {0, 1, 5}, {2, 3, 4});
  std::vector loads = {Load::shear,    Load::diagonal_shear, Load::bulk,
                       Load::shear_yz, Load::shear_zx,       Load::diagonal_shear_yz};
  for (const auto& pair : pairs_of_loads) loads.push_back(pair.both);
  const auto found = apparent_moduli(layers_of<3>(triclinic(), LinearMethod::iterative), loads);
  for (std::size_t i = 0; i < loads.size(); ++i) {
    EXPECT_NEAR(found[i] / modulus_under<3>(loads[i], exact), 1.0, 1e-7) << name_of(loads[i]);
  }
}

TEST(Crystals, InLayersOfPlaneStrainHaveTheExactStiffness) {
  StiffnessTensor<2> crystal;
  crystal << 30.0, 9.0, 2.0, 9.0, 25.0, -1.5, 2.0, -1.5, 7.0;
  const auto exact = laminate<2>(isotropic_stiffness<2>(binder), crystal, 0.25, {0}, {1, 2});
  constexpr std::array loads = {Load::shear,          Load::diagonal_shear,
                                Load::bulk,           Load::shear_and_diagonal_shear,
                                Load::shear_and_bulk, Load::diagonal_shear_and_bulk};
  for (const auto method : {LinearMethod::direct, LinearMethod::iterative}) {
    const auto found = apparent_moduli(layers_of<2>(in_space(crystal), method), loads);
    for (std::size_t i = 0; i < loads.size(); ++i) {
      EXPECT_NEAR(found[i] / modulus_under<2>(loads[i], exact), 1.0, 1e-7) << name_of(loads[i]);
    }
  }
}

// In plane strain the stress out of the plane is that of the constants in space.
template <int dim>
void expect_the_stress_of_a_uniform_strain() {
  const auto problem = layers_of<dim>(triclinic(), LinearMethod::iterative);
  const quasistatic::ElasticOperator<dim> elastic_operator(problem.discretisation, problem.volumetric, problem.boundary,
                                                           1, problem.crystals);
  for (const auto load : {Load::shear, Load::diagonal_shear, Load::bulk}) {
    const auto displacement = elastic_operator.uniform_strain(load);
    std::map<PhaseIndex, quasistatic::AppliedModuli> applied;
    applied.emplace(0, quasistatic::AppliedModuli{displacement.copy(), displacement.copy()});
    const auto fields = recover_fields(elastic_operator, problem.discretisation, problem.volumetric, load, displacement,
                                       applied, problem.crystals);
    Eigen::Matrix<double, 6, 1> strain = Eigen::Matrix<double, 6, 1>::Zero();
    for (int i = 0; i < tensor_components<dim>; ++i) {
      strain[strain_components<dim>[static_cast<std::size_t>(i)]] =
          (i < dim ? 1.0 : 2.0) * component(unit_strain<dim>(load), i);
    }
    const Eigen::Matrix<double, 6, 1> expected = triclinic() * strain;
    for (std::size_t place = 0; place < fields.phase.size(); ++place) {
      if (fields.phase[place] != 1) continue;
      const auto& stress = fields.stress[place];
      for (std::size_t i = 0; i < stress.size(); ++i) {
        EXPECT_NEAR(stress[i], expected[stress_components<dim>[i]], 1e-12) << name_of(load) << ", component " << i;
      }
    }
  }
}

TEST(Crystals, UnderAUniformStrainHaveTheStressOfTheirStiffness) {
  expect_the_stress_of_a_uniform_strain<2>();
  expect_the_stress_of_a_uniform_strain<3>();
}

/// Compares an isotropic filler given as a crystal with the same filler given by its moduli.
template <class Problem>
void expect_the_moduli_of_isotropic_phases(Problem problem) {
  constexpr std::array loads = {Load::shear, Load::bulk};
  const auto expected = apparent_moduli(problem, loads);
  const auto& filler = problem.materials[1];
  problem.crystals[1].stiffness = isotropic_stiffness<3>({filler.bulk.equilibrium(), filler.shear.equilibrium()});
  const auto found = apparent_moduli(problem, loads);
  for (std::size_t i = 0; i < loads.size(); ++i) EXPECT_NEAR(found[i] / expected[i], 1.0, 1e-6) << name_of(loads[i]);
}

TEST(Crystals, ThatAreIsotropicGiveTheModuliOfIsotropicPhases) {
  for (const auto volumetric : {Volumetric::averaged, Volumetric::standard}) {
    for (const auto boundary : test::boundaries) {
      auto disc = test::model_composite(8, volumetric, boundary);
      disc.linear.threads = 1;
      for (auto& material : disc.materials) {
        material = elastic({.bulk = material.bulk.equilibrium() + 1e6, .shear = material.shear.equilibrium() + 1e5});
      }
      expect_the_moduli_of_isotropic_phases(disc);
      QuasistaticProblem<3> ball = {.discretisation = Discretisation<3>(Grid<3>{{5, 5, 5}, 0.2}),
                                    .materials = {elastic(binder), elastic({.bulk = 40.0, .shear = 20.0})},
                                    .volumetric = volumetric,
                                    .boundary = boundary,
                                    .linear = {.threads = 1}};
      const auto is_inside = [](const Vector<3>& x) {
        return (x[0] - 0.4) * (x[0] - 0.4) + (x[1] - 0.5) * (x[1] - 0.5) + (x[2] - 0.55) * (x[2] - 0.55) < 0.1;
      };
      ball.discretisation.paint(is_inside, 1);
      expect_the_moduli_of_isotropic_phases(ball);
    }
  }
}

TEST(Crystals, AreNowhereSofterThanTheirSofterModuli) {
  const auto softer = softer_moduli<3>(triclinic());
  const Matrix6 difference = triclinic() - isotropic_stiffness<3>(softer);
  EXPECT_NEAR(difference.determinant() / triclinic().determinant(), 0.0, 1e-12);
  for (const auto& eigenvalue : difference.selfadjointView<Eigen::Lower>().eigenvalues()) EXPECT_GT(eigenvalue, -1e-12);
}

TEST(Crystals, ThatCannotBeAreRefused) {
  constexpr std::array loads = {Load::shear};
  const auto refuses = [&](const QuasistaticProblem<3>& problem) {
    EXPECT_THROW(static_cast<void>(apparent_moduli(problem, loads)), InputError);
  };
  auto indefinite = triclinic();
  indefinite(5, 5) = -1.0;
  refuses(layers_of<3>(indefinite, LinearMethod::iterative));
  auto unsymmetric = triclinic();
  unsymmetric(0, 5) += 1.0;
  refuses(layers_of<3>(unsymmetric, LinearMethod::iterative));
  auto of_the_binder = layers_of<3>(triclinic(), LinearMethod::iterative);
  of_the_binder.crystals = {{0, {triclinic()}}};
  refuses(of_the_binder);
  of_the_binder.crystals = {{7, {triclinic()}}};
  refuses(of_the_binder);
  auto mixed = layers_of<3>(triclinic(), LinearMethod::iterative);
  const auto mixture = mixed.discretisation.add_mixture({{0, 0.5}, {1, 0.5}}, 2);
  mixed.discretisation.fill({0, 0, 3}, mixture);
  mixed.materials.push_back(mixed.materials.back());
  refuses(mixed);
}

}  // namespace
}  // namespace breccia
