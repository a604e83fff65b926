#include "breccia/viscoelasticity/thermal_expansion.hpp"

#include <cmath>

#include <Eigen/Dense>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

namespace breccia {
namespace {

constexpr double of_matrix = 60e-6, of_filler = 10e-6;

/// Strain of the surface of a sphere of unit radius per kelvin: a core of the volume `fraction` in a shell. The core is
/// displaced by A r, the shell by B r + C / r^2.
double expansion_of_coated_sphere(double fraction, double core_bulk, double shell_bulk, double shell_shear) {
  const double a3 = fraction;
  Eigen::Matrix3d matrix;
  Eigen::Vector3d right;
  matrix << 1.0, -1.0, -1.0 / a3,                                  // the displacement is continuous
      3.0 * core_bulk, -3.0 * shell_bulk, 4.0 * shell_shear / a3,  // and so is the radial stress
      0.0, 3.0 * shell_bulk, -4.0 * shell_shear;                   // which vanishes at the surface
  right << 0.0, 3.0 * core_bulk * of_filler - 3.0 * shell_bulk * of_matrix, 3.0 * shell_bulk * of_matrix;
  const Eigen::Vector3d abc = matrix.fullPivLu().solve(right);
  return abc[1] + abc[2];
}

/// Bulk modulus of Hashin's assemblage of such spheres, of all sizes.
double bulk_of_coated_spheres(double fraction, double core_bulk, double shell_bulk, double shell_shear) {
  return shell_bulk +
         fraction / (1.0 / (core_bulk - shell_bulk) + 3.0 * (1.0 - fraction) / (3.0 * shell_bulk + 4.0 * shell_shear));
}

TEST(ThermalExpansion, IsThatOfACoatedSphere) {
  for (const double core : {0.0, 1e9, 40e9}) {
    ThermalExpansion expansion(of_matrix);
    expansion.add(
        {of_filler, PronySeries(core), PronySeries(3e9), PronySeries(bulk_of_coated_spheres(0.4, core, 3e9, 1e9))});
    EXPECT_NEAR(expansion.at(1.0), expansion_of_coated_sphere(0.4, core, 3e9, 1e9), 1e-14) << core;
  }
}

TEST(ThermalExpansion, OfASolidIsItsOwn) {
  const ThermalExpansion expansion(of_matrix);
  EXPECT_NEAR(expansion.at(1.0), of_matrix, 1e-15);
  EXPECT_EQ(expansion.sensitivity(1.0), 0.0);
}

// With elastic phases and a composite of K*(t) = 5 + 5 exp(-t) GPa the expansion is a part that stays plus one that is
// proportional to 1 / K*, whose function of time is the bulk creep compliance 1/5 - 1/10 exp(-t / 2) [1/GPa].
TEST(ThermalExpansion, FollowsTheBulkCreepComplianceOfTheComposite) {
  const double filler = 40e9, matrix = 3e9;
  ThermalExpansion expansion(of_matrix);
  expansion.add({of_filler, PronySeries(filler), PronySeries(matrix), PronySeries(5e9, {{1.0, 5e9}})});
  for (const double time : {1e-6, 0.1, 1.0, 10.0, 1e6}) {
    const double compliance = 1e-9 * (0.2 - 0.1 * std::exp(-0.5 * time));
    const double weight = filler * (matrix * compliance - 1.0) / (matrix - filler);
    EXPECT_NEAR(expansion.at(time), of_matrix + (of_filler - of_matrix) * weight, 1e-13) << time;
  }
}

TEST(ThermalExpansion, OfASecondStageTakesThatOfTheFirstAsItsMatrix) {
  const PronySeries first(7e9), second(12e9), filler(40e9), binder(3e9);
  ThermalExpansion one(of_matrix);
  one.add({of_filler, filler, binder, first});
  ThermalExpansion mean(one.at(1.0)), chain = one;
  mean.add({of_filler, filler, first, second});
  chain.add({of_filler, filler, first, second});
  EXPECT_NEAR(chain.at(1.0), mean.at(1.0), 1e-14);
  EXPECT_NE(chain.at(1.0), one.at(1.0));
}

TEST(ThermalExpansion, ItsSensitivityIsThatToTheBulkModulus) {
  const auto with = [](double bulk) {
    ThermalExpansion expansion(of_matrix);
    expansion.add({of_filler, PronySeries(40e9), PronySeries(3e9), PronySeries(bulk)});
    return expansion;
  };
  const double step = 1e-4,
               slope = (with(8e9 * std::exp(step)).at(1.0) - with(8e9 * std::exp(-step)).at(1.0)) / (2.0 * step);
  EXPECT_NEAR(with(8e9).sensitivity(1.0), std::abs(slope), 1e-11);
}

TEST(ThermalExpansion, IsDeterminedWhereTheBulkModuliKeepATenthApart) {
  const PronySeries relaxing(1e9, {{1.0, 3e9}});
  EXPECT_TRUE(determines_expansion(PronySeries(0.0), relaxing));
  EXPECT_TRUE(determines_expansion(PronySeries(0.89e9), relaxing));
  EXPECT_FALSE(determines_expansion(PronySeries(0.95e9), relaxing)) << "near the relaxed one";
  EXPECT_FALSE(determines_expansion(PronySeries(2e9), relaxing)) << "between";
  EXPECT_FALSE(determines_expansion(PronySeries(4.2e9), relaxing)) << "near the unrelaxed one";
  EXPECT_TRUE(determines_expansion(PronySeries(4.5e9), relaxing));
  EXPECT_FALSE(determines_expansion(relaxing, PronySeries(30e9))) << "a filler that relaxes";
  ThermalExpansion expansion(of_matrix);
  EXPECT_THROW(expansion.add({of_filler, PronySeries(2e9), relaxing, PronySeries(2e9)}), InputError);
}

}  // namespace
}  // namespace breccia
