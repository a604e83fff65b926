#include "quasistatic/reduced/response_gradient.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include <gtest/gtest.h>

#include "one_vector_response.hpp"

namespace breccia {
namespace {

/// Layers of the matrix (a share f of the thickness) and of a coating under shear across them, C = f / G_1 +
/// (1 - f) / G_2: the strain of each layer is one vector.
ReducedResponse laminate(double share) {
  auto response = test::one_vector_response(Load::shear, Boundary::periodic, {}, {});
  const auto diagonal = [](double first, double second) -> Eigen::MatrixXd {
    return Eigen::Vector2d(first, second).asDiagonal();
  };
  response.constant = diagonal(0.0, 0.0);
  response.parts = matrix_parts(diagonal(1.0 / share, 0.0), diagonal(0.0, 0.0));
  response.parts.push_back({{"coating", ElasticModulus::shear}, diagonal(0.0, 1.0 / (1.0 - share))});
  response.parts.push_back({{"coating", ElasticModulus::bulk}, diagonal(0.0, 0.0)});
  response.load_forces = Eigen::VectorXd::Ones(2);
  return response;
}

TEST(ResponseGradient, OfALaminateIsExact) {
  constexpr double f = 0.3, soft = 2e6, hard = 5e9;
  const std::complex<double> lossy = {soft, 0.7 * soft};
  const std::vector<ComplexModuli> moduli = {{.bulk = 1e9, .shear = lossy}, {.bulk = 8e9, .shear = hard}};
  const auto [compliance, gradient] = compliance_and_gradient(laminate(f), moduli);
  EXPECT_LT(std::abs(compliance / (f / lossy + (1.0 - f) / hard) - 1.0), 1e-14);
  ASSERT_EQ(gradient.size(), 2U);
  EXPECT_LT(std::abs(gradient[0].shear / (-f / (lossy * lossy)) - 1.0), 1e-13);
  EXPECT_LT(std::abs(gradient[1].shear / (-(1.0 - f) / (hard * hard)) - 1.0), 1e-13);
  EXPECT_EQ(gradient[0].bulk, 0.0);
  EXPECT_EQ(gradient[1].bulk, 0.0);
  const auto of_modulus = modulus_and_gradient(laminate(f), moduli);
  EXPECT_LT(std::abs(of_modulus.value * compliance - 1.0), 1e-14);
  EXPECT_LT(std::abs(of_modulus.gradient[0].shear / (f / (lossy * lossy) / (compliance * compliance)) - 1.0), 1e-13);
}

TEST(ResponseGradient, OfAModulusThatIsLinearInItsMatrixIsConstant) {
  const auto response = test::one_vector_response(Load::bulk, Boundary::displacement, {1e6, 2.5, 0.75}, {});
  for (const double shear : {1e4, 1e6, 1e9}) {
    const std::vector<ComplexModuli> moduli = {{.bulk = 3e9, .shear = shear}};
    const auto [modulus, gradient] = modulus_and_gradient(response, moduli);
    EXPECT_NEAR(modulus.real() / (1e6 + 2.5 * shear + 0.75 * 3e9), 1.0, 1e-14);
    EXPECT_EQ(modulus.imag(), 0.0) << "moduli are real where those of the phases are";
    EXPECT_NEAR(gradient[0].shear.real(), 2.5, 1e-13);
    EXPECT_NEAR(gradient[0].bulk.real(), 0.75, 1e-13);
  }
}

/// A response of three vectors whose parts do not commute.
ReducedResponse of_three_vectors() {
  auto response = test::one_vector_response(Load::shear, Boundary::traction, {}, {});
  Eigen::Matrix3d constant, shear, bulk;
  constant << 5e9, 1e9, 0.0, 1e9, 4e9, 2e9, 0.0, 2e9, 6e9;
  shear << 3.0, 0.5, 0.2, 0.5, 2.0, -0.4, 0.2, -0.4, 1.0;
  bulk << 0.5, 0.1, 0.0, 0.1, 0.2, 0.05, 0.0, 0.05, 0.1;
  response.constant = constant;
  response.parts = matrix_parts(shear, bulk);
  response.load_forces = Eigen::Vector3d(1.0, -0.5, 2.0);
  return response;
}

// A central difference errs by about the square of its step, here 1e-8 of the modulus, and by rounding over the step.
TEST(ResponseGradient, AgreesWithFiniteDifferences) {
  const auto response = of_three_vectors();
  for (const Moduli& at : {Moduli{.bulk = 2e9, .shear = 1e6}, Moduli{.bulk = 3e9, .shear = 8e8}}) {
    const ComplexModuli moduli = {.bulk = at.bulk, .shear = at.shear};
    const auto [modulus, gradient] = modulus_and_gradient(response, std::span(&moduli, 1));
    constexpr double step = 1e-4;
    const auto difference = [&](double Moduli::*which) {
      auto more = at, less = at;
      more.*which *= 1.0 + step;
      less.*which *= 1.0 - step;
      return (response.modulus(more) - response.modulus(less)) / (2.0 * step * at.*which);
    };
    EXPECT_NEAR(gradient[0].shear.real() / difference(&Moduli::shear), 1.0, 1e-6);
    EXPECT_NEAR(gradient[0].bulk.real() / difference(&Moduli::bulk), 1.0, 1e-6);
    EXPECT_NEAR(modulus.real() / response.modulus(at), 1.0, 1e-14);
  }
}

}  // namespace
}  // namespace breccia
