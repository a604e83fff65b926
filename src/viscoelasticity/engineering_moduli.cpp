#include "viscoelasticity/engineering_moduli.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace breccia {
namespace {

using Complex = std::complex<double>;

/// The Carson transform of a modulus: s times its Laplace transform, at the Laplace variable s.
Complex carson_transform(const PronySeries& modulus, Complex s) {
  Complex sum = modulus.equilibrium();
  for (const auto& [time, strength] : modulus.terms()) sum += strength * (s * time) / (1.0 + s * time);
  return sum;
}

Complex youngs_modulus_of(Complex bulk, Complex shear) {
  return 9.0 * bulk * shear / (3.0 * bulk + shear);
}
Complex poisson_ratio_of(Complex bulk, Complex shear) {
  return 0.5 * (3.0 * bulk - 2.0 * shear) / (3.0 * bulk + shear);
}

/// The function of time whose Laplace transform times s is given, by Talbot's method with a fixed contour. All
/// singularities of the transform must be on the negative real axis, as those of relaxing solids are.
template <class Transform>
double function_of_time(const Transform& times_s, double t) {
  constexpr int nodes = 20;
  const double scale = 2.0 * nodes / (5.0 * t);
  double sum = 0.5 * std::exp(scale * t) * times_s(Complex(scale)).real() / scale;
  for (int k = 1; k < nodes; ++k) {
    const double angle = k * std::numbers::pi / nodes, cotangent = 1.0 / std::tan(angle);
    const Complex s = scale * angle * Complex(cotangent, 1.0);
    const Complex slope(1.0, angle + (angle * cotangent - 1.0) * cotangent);
    sum += (std::exp(t * s) * times_s(s) / s * slope).real();
  }
  return sum * scale / nodes;
}

}  // namespace

EngineeringModuli::EngineeringModuli(PronySeries shear, PronySeries bulk)
    : shear_(std::move(shear)), bulk_(std::move(bulk)) {}

double EngineeringModuli::youngs_modulus(double t) const {
  return function_of_time(
      [this](Complex s) { return youngs_modulus_of(carson_transform(bulk_, s), carson_transform(shear_, s)); }, t);
}

double EngineeringModuli::poisson_ratio(double t) const {
  return function_of_time(
      [this](Complex s) { return poisson_ratio_of(carson_transform(bulk_, s), carson_transform(shear_, s)); }, t);
}

Complex EngineeringModuli::complex_youngs_modulus(double omega) const {
  return youngs_modulus_of(bulk_.complex_modulus(omega), shear_.complex_modulus(omega));
}

Complex EngineeringModuli::complex_poisson_ratio(double omega) const {
  return poisson_ratio_of(bulk_.complex_modulus(omega), shear_.complex_modulus(omega));
}

}  // namespace breccia
