#include "quasistatic/operator/mixed_cell.hpp"

#include <array>
#include <random>

#include <gtest/gtest.h>

#include "test_names.hpp"

namespace breccia::quasistatic {
namespace {

template <class Dimension>
class AnyMixedCell : public testing::Test {
 public:
  static constexpr int dim = Dimension::value;
  using Shape = CellShape<dim>;
  using Modes = typename Shape::ModeValues;

  const std::array<Moduli, 4> moduli = {{{.bulk = 5.0, .shear = 3.0}, {7.0, 40.0}, {2.0, 0.5}, {1.0, 0.2}}};
  const std::array<Material, 4> materials = {{{"matrix", 1.0, PronySeries(5.0), PronySeries(3.0)},
                                              {"stiff", 1.0, PronySeries(7.0), PronySeries(40.0)},
                                              {"soft", 1.0, PronySeries(2.0), PronySeries(0.5)},
                                              {"softer", 1.0, PronySeries(1.0), PronySeries(0.2)}}};
  const std::array<Material, 4> soft = {materials[0], materials[2], materials[2], materials[3]};
  /// Three phases in series, and a matrix that holds two phases.
  const std::array<MixtureRule, 2> rules = {MixtureRule({{1, 0.25}, {0, 0.625}, {2, 0.125}}, materials),
                                            MixtureRule({{2, 0.25}, {3, 0.5}, {0, 0.25}}, soft)};

  Eigen::VectorXd random(Eigen::Index size) {
    Eigen::VectorXd values(size);
    for (auto& value : values) value = std::uniform_real_distribution<double>(-1.0, 1.0)(generator_);
    return values;
  }
  static Modes stress_of(const Moduli& of_cell, const Modes& strain) {
    Modes stress = of_cell.shear * strain;
    stress[Shape::modes - 1] =
        (dim == 2 ? of_cell.bulk + of_cell.shear / 3.0 : of_cell.bulk) * strain[Shape::modes - 1];
    return stress;
  }
  static typename MixedCell<dim>::Strains view(const Eigen::VectorXd& values) { return {values.data(), values.size()}; }

 private:
  std::mt19937_64 generator_{1};
};

using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(AnyMixedCell, Dimensions, breccia::test::DimensionNames);

// The modes of a cell are those of its stiffness.
TYPED_TEST(AnyMixedCell, ModesGiveTheStiffnessOfOneMaterial) {
  using Shape = typename TestFixture::Shape;
  typename Shape::PointModuli moduli{};
  moduli.fill({.bulk = 7.0, .shear = 3.0});
  typename TestFixture::Modes weights = TestFixture::Modes::Constant(3.0);
  weights[Shape::modes - 1] = TestFixture::dim == 2 ? 7.0 + 3.0 / 3.0 : 7.0;
  const auto modes = Shape::mode_matrix();
  const typename Shape::Stiffness stiffness = modes.transpose() * weights.asDiagonal() * modes;
  EXPECT_LT((stiffness - Shape::stiffness(moduli, Volumetric::averaged)).norm(), 1e-13 * stiffness.norm());
}

TYPED_TEST(AnyMixedCell, PhasesThatStrainAlikeActInParallel) {
  for (const auto& rule : this->rules) {
    const MixedCell<TestFixture::dim> cell(rule);
    const typename TestFixture::Modes strain = this->random(TestFixture::Shape::modes);
    const auto unknown = cell.uniform(strain);
    for (std::size_t part = 0; part < 3; ++part) {
      EXPECT_LT((cell.strain_of(part, strain, this->view(unknown)) - strain).norm(), 1e-14);
    }
  }
}

TYPED_TEST(AnyMixedCell, TheMeanOfTheStrainsIsThatOfTheCell) {
  for (const auto& rule : this->rules) {
    const MixedCell<TestFixture::dim> cell(rule);
    const typename TestFixture::Modes strain = this->random(TestFixture::Shape::modes);
    const auto unknown = this->random(cell.unknowns());
    typename TestFixture::Modes mean = TestFixture::Modes::Zero();
    for (std::size_t part = 0; part < 3; ++part) {
      mean += cell.mixture()[part].fraction * cell.strain_of(part, strain, this->view(unknown));
    }
    EXPECT_LT((mean - strain).norm(), 1e-14);
  }
}

// Without forces on the strains the stress is that of the moduli of the mixture.
TYPED_TEST(AnyMixedCell, InEquilibriumHasTheStressOfItsModuli) {
  for (const auto& rule : this->rules) {
    const MixedCell<TestFixture::dim> cell(rule);
    const auto of_cell = rule.template moduli<TestFixture::dim>(this->moduli);
    const typename TestFixture::Modes strain = this->random(TestFixture::Shape::modes);
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(cell.unknowns());
    const auto strains = cell.strains_under(this->moduli, strain, this->view(none));
    const auto [stress, forces] = cell.stresses(this->moduli, strain, this->view(strains));
    const typename TestFixture::Modes expected = TestFixture::stress_of(of_cell, strain);
    EXPECT_LT((stress - expected).norm(), 1e-13 * expected.norm());
    EXPECT_LT(forces.norm(), 1e-13 * expected.norm());
  }
}

TYPED_TEST(AnyMixedCell, UnderForcesIsInEquilibriumWithThem) {
  for (const auto& rule : this->rules) {
    const MixedCell<TestFixture::dim> cell(rule);
    const auto of_cell = rule.template moduli<TestFixture::dim>(this->moduli);
    const typename TestFixture::Modes strain = this->random(TestFixture::Shape::modes);
    const auto applied = this->random(cell.unknowns());
    const auto strains = cell.strains_under(this->moduli, strain, this->view(applied));
    const auto [stress, forces] = cell.stresses(this->moduli, strain, this->view(strains));
    const typename TestFixture::Modes expected =
        TestFixture::stress_of(of_cell, strain) - cell.stress_relieved_by(this->moduli, this->view(applied));
    EXPECT_LT((forces - applied).norm(), 1e-13 * (applied.norm() + expected.norm()));
    EXPECT_LT((stress - expected).norm(), 1e-13 * expected.norm());
  }
}

// The projection of the reduced basis relies on this; its parts include moduli of zero.
TYPED_TEST(AnyMixedCell, StressesAreAffineInTheModuli) {
  for (const auto& rule : this->rules) {
    const MixedCell<TestFixture::dim> cell(rule);
    const typename TestFixture::Modes strain = this->random(TestFixture::Shape::modes);
    const auto unknown = this->random(cell.unknowns());
    std::array<Moduli, 4> sum = this->moduli;
    const std::array<Moduli, 4> part = {{{0.5, 0.7}, {.bulk = 0.0, .shear = 11.0}, {.bulk = 3.0, .shear = 0.0}, {}}};
    for (std::size_t m = 0; m < sum.size(); ++m) {
      sum[m].bulk += part[m].bulk;
      sum[m].shear += part[m].shear;
    }
    const auto first = cell.stresses(this->moduli, strain, this->view(unknown));
    const auto second = cell.stresses(part, strain, this->view(unknown));
    const auto both = cell.stresses(sum, strain, this->view(unknown));
    EXPECT_LT((first.first + second.first - both.first).norm(), 1e-12 * both.first.norm());
    EXPECT_LT((first.second + second.second - both.second).norm(), 1e-12 * both.second.norm());
  }
}

TYPED_TEST(AnyMixedCell, SharesAreTheStrainsInEquilibrium) {
  using Shape = typename TestFixture::Shape;
  for (const auto& rule : this->rules) {
    const MixedCell<TestFixture::dim> cell(rule);
    const typename TestFixture::Modes strain = this->random(Shape::modes);
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(cell.unknowns());
    const auto strains = cell.strains_under(this->moduli, strain, this->view(none));
    const auto shares = cell.shares(this->moduli);
    for (std::size_t part = 1; part < cell.mixture().size(); ++part) {
      const auto& [volumetric, deviatoric] = shares[part - 1];
      typename TestFixture::Modes expected = deviatoric * strain;
      expected[Shape::modes - 1] = volumetric * strain[Shape::modes - 1];
      EXPECT_LT((cell.strain_of(part, strain, this->view(strains)) - expected).norm(), 1e-13 * strain.norm());
    }
  }
}

}  // namespace
}  // namespace breccia::quasistatic
