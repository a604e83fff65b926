#include "quasistatic/reduced/network.hpp"

#include <array>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "breccia/viscoelasticity/interconversion.hpp"

#include "quasistatic/composites.hpp"
#include "quasistatic/reduced/carson_path.hpp"

namespace breccia::quasistatic {
namespace {

ReducedResponse response_of(const Eigen::MatrixXd& filler, const Eigen::MatrixXd& shear, const Eigen::MatrixXd& bulk,
                            const Eigen::VectorXd& load_forces, Boundary boundary = Boundary::traction) {
  ReducedResponse response;
  response.boundary = boundary;
  response.constant = filler;
  response.parts = matrix_parts(shear, bulk);
  response.load_forces = load_forces;
  return response;
}

Material material_of(PronySeries bulk, PronySeries shear) {
  return {"m", 1000.0, std::move(bulk), std::move(shear)};
}

/// A response with two vectors whose three parts do not commute.
ReducedResponse two_vectors(Boundary boundary = Boundary::traction) {
  return response_of(Eigen::MatrixXd{{5.0, 1.0}, {1.0, 3.0}}, Eigen::MatrixXd{{2.0, -0.5}, {-0.5, 1.0}},
                     Eigen::MatrixXd{{1.0, 0.3}, {0.3, 0.5}}, Eigen::VectorXd{{1.0, 2.0}}, boundary);
}

/// Its matrix relaxes at 1 us and 10 s in shear, and at 10 ms in volume.
const Material relaxing = material_of(PronySeries(4.0, {{1e-2, 3.0}}), PronySeries(1e-3, {{1e-6, 2.0}, {10.0, 0.5}}));

// The composite modulus a + b G(t) + c K(t) is a Prony series of two terms, whose retardation times are the roots of a
// quadratic equation.
TEST(NetworkCompliance, OfOneVectorIsTheCreepOfASolidOfTwoTerms) {
  const double a = 3.0, b = 2.0, c = 0.5;
  const double m0 = a + b * 0.25 + c * 1.5, m1 = b * 4.0, m2 = c * 6.0, tau1 = 1e-3, tau2 = 2.0;
  const auto one = [](double x) { return Eigen::MatrixXd::Constant(1, 1, x); };
  const auto compliance =
      network_compliance(response_of(one(a), one(b), one(c), Eigen::VectorXd::Ones(1)),
                         std::array{material_of(PronySeries(1.5, {{tau2, 6.0}}), PronySeries(0.25, {{tau1, 4.0}}))});
  // M(s) (1 + s tau1) (1 + s tau2) = m0 + s p + s^2 q
  const double p = m0 * (tau1 + tau2) + m1 * tau1 + m2 * tau2, q = (m0 + m1 + m2) * tau1 * tau2;
  const double root = std::sqrt(p * p - 4.0 * q * m0);
  EXPECT_NEAR(compliance.instantaneous() * (m0 + m1 + m2), 1.0, 1e-14);
  ASSERT_EQ(compliance.terms().size(), 2U);
  EXPECT_NEAR(compliance.terms()[0].retardation_time / ((p + root) / (2.0 * m0)), 1.0, 1e-13);
  EXPECT_NEAR(compliance.terms()[1].retardation_time / (2.0 * q / (p + root)), 1.0, 1e-13);
  double relaxed = compliance.instantaneous();
  for (const auto& term : compliance.terms()) relaxed += term.compliance;
  EXPECT_NEAR(relaxed * m0, 1.0, 1e-14);
}

// The expected values are from poles and residues of the 2 x 2 inverse, with 60 digits.
TEST(NetworkCompliance, AgreesWithPartialFractionsOfSixtyDigits) {
  const auto compliance = network_compliance(two_vectors(), std::array{relaxing});
  constexpr std::array<std::pair<double, double>, 8> expected = {{{0.0, 0.46526953588194121892},
                                                                  {1e-7, 0.47317819208008944045},
                                                                  {1e-6, 0.52263178928390530299},
                                                                  {1e-3, 0.5863535589748422959},
                                                                  {1e-2, 0.66167487229611481681},
                                                                  {1.0, 0.74173386466228466849},
                                                                  {30.0, 0.79690155342075482156},
                                                                  {1000.0, 0.8016435197834768593}}};
  for (const auto& [time, value] : expected) EXPECT_NEAR(compliance.at(time) / value, 1.0, 1e-13) << time;
}

TEST(NetworkCompliance, HasTheCarsonTransformOfTheElasticResponse) {
  const auto response = two_vectors();
  const auto compliance = network_compliance(response, std::array{relaxing});
  for (const double s : breccia::test::logarithmic(1e-6, 1e10, 2)) {
    double transform = compliance.instantaneous();
    for (const auto& [time, strength] : compliance.terms()) transform += strength / (1.0 + s * time);
    EXPECT_NEAR(transform * response.modulus(carson_moduli(relaxing, s)), 1.0, 1e-12) << s;
  }
}

TEST(NetworkCompliance, OfVectorsThatDoNotInteractIsASum) {
  const Eigen::Vector3d a{1.0, 2.0, 0.5}, b{3.0, 1.0, 2.0}, c{0.5, 0.1, 4.0}, e{1.0, -2.0, 0.5};
  const auto whole =
      network_compliance(response_of(a.asDiagonal(), b.asDiagonal(), c.asDiagonal(), e), std::array{relaxing});
  for (const double time : {0.0, 1e-6, 1e-2, 20.0, 1e4}) {
    double sum = 0.0;
    for (Eigen::Index i = 0; i < 3; ++i) {
      const auto one = [](double x) { return Eigen::MatrixXd::Constant(1, 1, x); };
      const auto part = response_of(one(a[i]), one(b[i]), one(c[i]), Eigen::VectorXd::Ones(1));
      sum += e[i] * e[i] * network_compliance(part, std::array{relaxing}).at(time);
    }
    EXPECT_NEAR(whole.at(time) / sum, 1.0, 1e-12) << time;
  }
}

TEST(NetworkCompliance, OfAModeThatNothingHoldsGrowsInATimeBeyondAllOthers) {
  // The second vector is held by the shear modulus of the matrix alone, which relaxes to nothing.
  const auto compliance =
      network_compliance(response_of(Eigen::MatrixXd{{1.0, 0.0}, {0.0, 0.0}}, Eigen::MatrixXd::Identity(2, 2),
                                     Eigen::MatrixXd{{1.0, 0.0}, {0.0, 0.0}}, Eigen::VectorXd::Ones(2)),
                         std::array{material_of(PronySeries(1.0, {{1.0, 1.0}}), PronySeries(0.0, {{1e-3, 1.0}}))});
  EXPECT_GT(compliance.terms().front().retardation_time, 1e10);
  // Until then it flows like a Maxwell element, 1 + t / tau, with the accuracy of the square root of the rounding level
  // that replaces a zero stiffness.
  const auto held =
      network_compliance(response_of(Eigen::MatrixXd::Ones(1, 1), Eigen::MatrixXd::Ones(1, 1),
                                     Eigen::MatrixXd::Ones(1, 1), Eigen::VectorXd::Ones(1)),
                         std::array{material_of(PronySeries(1.0, {{1.0, 1.0}}), PronySeries(0.0, {{1e-3, 1.0}}))});
  for (const double time : {1e-4, 1e-2, 10.0}) {
    EXPECT_NEAR((compliance.at(time) - held.at(time)) / (1.0 + time / 1e-3), 1.0, 1e-7) << time;
  }
}

TEST(NetworkState, OfOneVectorUnderAHeldStrainIsTheRelaxationOfTheMatrix) {
  const auto one = [](double x) { return Eigen::MatrixXd::Constant(1, 1, x); };
  const auto response =
      response_of(one(3.0), one(2.0), one(0.5), Eigen::VectorXd::Constant(1, 4.0), Boundary::displacement);
  for (const double time : {0.0, 1e-6, 1e-2, 20.0}) {
    const auto state = network_state(response, std::array{relaxing}, time);
    EXPECT_NEAR(state.displacement[0], 0.25, 1e-14);
    EXPECT_NEAR(state.applied[0][0] / (0.25 * relaxing.shear.at(time)), 1.0, 1e-12) << time;
    EXPECT_NEAR(state.applied[1][0] / (0.25 * relaxing.bulk.at(time)), 1.0, 1e-12) << time;
  }
}

TEST(NetworkState, IsInBalanceWithTheLoad) {
  for (const auto boundary : breccia::test::boundaries) {
    const auto response = two_vectors(boundary);
    const auto& e = response.load_forces;
    const auto compliance = network_compliance(response, std::array{relaxing});
    const auto modulus = relaxation_modulus(compliance);
    for (const double time : {0.0, 1e-7, 1e-3, 0.5, 30.0, 1e3}) {
      const auto state = network_state(response, std::array{relaxing}, time);
      const Eigen::VectorXd forces = response.constant * state.displacement +
                                     response.part(ElasticModulus::shear) * state.applied[0] +
                                     response.part(ElasticModulus::bulk) * state.applied[1];
      const bool is_traction = boundary == Boundary::traction;
      const double stress = is_traction ? 1.0 : modulus.at(time), strain = is_traction ? compliance.at(time) : 1.0;
      EXPECT_LT((forces - stress * e).norm(), 1e-12 * stress * e.norm()) << time;
      EXPECT_NEAR(e.dot(state.displacement) / strain, 1.0, 1e-12) << time;
    }
  }
}

TEST(NetworkState, RelaxesToTheElasticSolutionOfTheEquilibriumModuli) {
  const auto response = two_vectors(Boundary::traction);
  const auto state = network_state(response, std::array{relaxing}, 1e9);
  const auto stiffness =
      response.stiffness(response.parameters({relaxing.bulk.equilibrium(), relaxing.shear.equilibrium()}));
  const Eigen::VectorXd expected = stiffness.fullPivLu().solve(response.load_forces);
  EXPECT_LT((state.displacement - expected).norm(), 1e-12 * expected.norm());
  EXPECT_LT((state.applied[0] - relaxing.shear.equilibrium() * expected).norm(), 1e-12 * state.applied[1].norm());
  EXPECT_LT((state.applied[1] - relaxing.bulk.equilibrium() * expected).norm(), 1e-12 * state.applied[1].norm());
}

}  // namespace
}  // namespace breccia::quasistatic
