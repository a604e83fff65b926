#include "assessment/observed_value.hpp"

#include <cmath>
#include <cstddef>

namespace breccia {
namespace {

using Complex = std::complex<double>;

/// A value over frequency of a complex modulus.
double value_at_frequency(ObservedCurve curve, Complex modulus) {
  if (curve == ObservedCurve::storage) return modulus.real();
  if (curve == ObservedCurve::loss) return modulus.imag();
  return curve == ObservedCurve::absolute ? std::abs(modulus) : std::arg(modulus);
}

double change_at_frequency(ObservedCurve curve, Complex modulus, Complex change) {
  if (curve == ObservedCurve::storage) return change.real();
  if (curve == ObservedCurve::loss) return change.imag();
  const auto relative = change / modulus;
  return curve == ObservedCurve::absolute ? std::abs(modulus) * relative.real() : relative.imag();
}

/// s times the Laplace transform of a curve over time, from the Carson modulus at s. The stress over the strain at a
/// constant rate is the mean of the relaxation modulus from 0 to t.
Complex transform_of(ObservedCurve curve, double time, Complex s, Complex modulus) {
  if (curve == ObservedCurve::creep) return 1.0 / modulus;
  return curve == ObservedCurve::constant_rate ? modulus / (s * time) : modulus;
}

Complex change_of_transform(ObservedCurve curve, double time, Complex s, Complex modulus, Complex change) {
  if (curve == ObservedCurve::creep) return -change / (modulus * modulus);
  return curve == ObservedCurve::constant_rate ? change / (s * time) : change;
}

}  // namespace

ObservedValue::ObservedValue(const Observation& observation) : curve_(observation.curve), at_(observation.at) {
  constexpr int nodes = 16;
  if (is_over_frequency(curve_)) {
    variables_ = {{0.0, at_}};
  } else {
    contour_.emplace(at_, nodes);
    variables_ = contour_->variables();
  }
}

double ObservedValue::value(std::span<const Complex> moduli) const {
  if (!contour_) return value_at_frequency(curve_, moduli.front());
  std::vector<Complex> transforms;
  for (std::size_t k = 0; k < moduli.size(); ++k) {
    transforms.push_back(transform_of(curve_, at_, variables_[k], moduli[k]));
  }
  return contour_->function(transforms);
}

double ObservedValue::change(std::span<const Complex> moduli, std::span<const Complex> changes) const {
  if (!contour_) return change_at_frequency(curve_, moduli.front(), changes.front());
  std::vector<Complex> transforms;
  for (std::size_t k = 0; k < moduli.size(); ++k) {
    transforms.push_back(change_of_transform(curve_, at_, variables_[k], moduli[k], changes[k]));
  }
  return contour_->function(transforms);
}

int ObservedValue::power_of_factor() const {
  if (curve_ == ObservedCurve::phase) return 0;
  return curve_ == ObservedCurve::creep ? -1 : 1;
}

OfShearAndBulk observed_modulus(ObservedModulus modulus, Complex shear, Complex bulk) {
  const auto sum = 3.0 * bulk + shear;
  switch (modulus) {
    case ObservedModulus::shear:
      return {shear, 1.0, 0.0};
    case ObservedModulus::bulk:
      return {bulk, 0.0, 1.0};
    case ObservedModulus::p_wave:
      return {bulk + 4.0 / 3.0 * shear, 4.0 / 3.0, 1.0};
    case ObservedModulus::young:
      break;
  }
  return {9.0 * bulk * shear / sum, 27.0 * bulk * bulk / (sum * sum), 9.0 * shear * shear / (sum * sum)};
}

}  // namespace breccia
