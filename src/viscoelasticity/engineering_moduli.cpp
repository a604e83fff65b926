#include "viscoelasticity/engineering_moduli.hpp"

#include <utility>
#include <vector>

#include "breccia/viscoelasticity/carson_moduli.hpp"

#include "viscoelasticity/talbot_contour.hpp"

namespace breccia {
namespace {

using Complex = std::complex<double>;

Complex youngs_modulus_of(Complex bulk, Complex shear) {
  return 9.0 * bulk * shear / (3.0 * bulk + shear);
}
Complex poisson_ratio_of(Complex bulk, Complex shear) {
  return 0.5 * (3.0 * bulk - 2.0 * shear) / (3.0 * bulk + shear);
}

/// The function of time whose Laplace transform times s is given.
template <class Transform>
double function_of_time(const Transform& times_s, double t) {
  constexpr int nodes = 20;
  const TalbotContour contour(t, nodes);
  std::vector<Complex> values;
  for (const auto s : contour.variables()) values.push_back(times_s(s));
  return contour.function(values);
}

}  // namespace

EngineeringModuli::EngineeringModuli(PronySeries shear, PronySeries bulk)
    : shear_(std::move(shear)), bulk_(std::move(bulk)) {}

double EngineeringModuli::youngs_modulus(double t) const {
  return function_of_time(
      [this](Complex s) { return youngs_modulus_of(carson_modulus(bulk_, s), carson_modulus(shear_, s)); }, t);
}

double EngineeringModuli::tensile_compliance(double t) const {
  return function_of_time(
      [this](Complex s) { return 1.0 / youngs_modulus_of(carson_modulus(bulk_, s), carson_modulus(shear_, s)); }, t);
}

double EngineeringModuli::poisson_ratio(double t) const {
  return function_of_time(
      [this](Complex s) { return poisson_ratio_of(carson_modulus(bulk_, s), carson_modulus(shear_, s)); }, t);
}

Complex EngineeringModuli::complex_youngs_modulus(double omega) const {
  return youngs_modulus_of(bulk_.complex_modulus(omega), shear_.complex_modulus(omega));
}

Complex EngineeringModuli::complex_poisson_ratio(double omega) const {
  return poisson_ratio_of(bulk_.complex_modulus(omega), shear_.complex_modulus(omega));
}

}  // namespace breccia
