#include "assessment/curve_values.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

#include "assessment/observed_value.hpp"

namespace breccia {
Between between(const std::vector<double>& at, double place) {
  const auto above = std::ranges::upper_bound(at, place);
  const auto second = std::clamp<std::ptrdiff_t>(above - at.begin(), 1, std::ssize(at) - 1);
  const double low = at[static_cast<std::size_t>(second - 1)], high = at[static_cast<std::size_t>(second)];
  return {second - 1, second, std::clamp(std::log(place / low) / std::log(high / low), 0.0, 1.0)};
}

CurveValues values_of_sample(const std::vector<SampledCurve>& curves, Eigen::Index sample) {
  CurveValues values;
  for (const auto& curve : curves) {
    const Eigen::VectorXd own = curve.values.col(sample);
    values.emplace_back(curve.curve == ObservedCurve::phase ? own : Eigen::VectorXd(own.array().log()));
  }
  return values;
}

double interpolated(const SampledCurve& curve, const Eigen::VectorXd& values, double at) {
  const auto [first, second, share] = between(curve.at, at);
  const double value = std::lerp(values[first], values[second], share);
  return curve.curve == ObservedCurve::phase ? value : std::exp(value);
}

const SampledCurve* curve_of(const std::vector<SampledCurve>& curves, ObservedModulus modulus, ObservedCurve curve) {
  const auto found = std::ranges::find_if(
      curves, [&](const SampledCurve& one) { return one.modulus == modulus && one.curve == curve; });
  return found == curves.end() ? nullptr : &*found;
}

std::complex<double> modulus_at(const std::vector<SampledCurve>& curves, const CurveValues& values,
                                ObservedModulus modulus, double at) {
  const auto value_of = [&](const SampledCurve& curve) {
    return interpolated(curve, values[static_cast<std::size_t>(&curve - curves.data())], at);
  };
  if (const auto* const absolute = curve_of(curves, modulus, ObservedCurve::absolute)) {
    return std::polar(value_of(*absolute), value_of(*curve_of(curves, modulus, ObservedCurve::phase)));
  }
  return value_of(*curve_of(curves, modulus, ObservedCurve::relaxation));
}

double observed_value(const std::vector<SampledCurve>& curves, const CurveValues& values,
                      const Observation& observation) {
  const auto shear = modulus_at(curves, values, ObservedModulus::shear, observation.at);
  std::complex<double> bulk = 0.0;
  if (observation.modulus != ObservedModulus::shear) {
    const auto& tested = *curve_of(curves, ObservedModulus::bulk, curves.front().curve);
    bulk = modulus_at(curves, values, ObservedModulus::bulk, observation.at) - tested.share_of_shear * shear;
  }
  const auto modulus = observed_modulus(observation.modulus, shear, bulk).value;
  switch (observation.curve) {
    case ObservedCurve::loss:
      return modulus.imag();
    case ObservedCurve::absolute:
      return std::abs(modulus);
    case ObservedCurve::phase:
      return std::arg(modulus);
    default:
      return modulus.real();
  }
}

}  // namespace breccia
