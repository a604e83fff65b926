#include "breccia/virtual_test/curve.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>
#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia {

std::vector<double> logarithmic_times(const TimeWindow& window, int per_decade) {
  if (per_decade < 1) throw InputError(fmt::format("times: expected at least one a decade, got {}", per_decade));
  constexpr double tolerance = 1e-9;
  std::vector<double> times = {window.begin};
  const double first = std::floor(std::log10(window.begin) * per_decade + tolerance) + 1.0;
  for (double k = first;; ++k) {
    const double time = std::pow(10.0, k / per_decade);
    if (time >= window.end * (1.0 - tolerance)) break;
    times.push_back(time);
  }
  if (window.end > window.begin) times.push_back(window.end);
  return times;
}

double smoothed_at(std::span<const Sample> curve, double time) {
  if (curve.empty() || time < curve.front().time || time > curve.back().time) {
    throw InputError(fmt::format("curve: no modulus is known at {:.6e} s", time));
  }
  constexpr double decades = 1.0 / 40.0;
  const double reach = std::pow(10.0, decades);
  const auto begin = std::ranges::lower_bound(curve, time / reach, {}, &Sample::time);
  const auto end = std::ranges::upper_bound(curve, time * reach, {}, &Sample::time);
  const auto count = static_cast<Eigen::Index>(end - begin);
  if (count < 5) {
    if (curve.size() == 1) return curve.front().modulus;
    const auto right = std::max(curve.begin() + 1, std::ranges::lower_bound(curve, time, {}, &Sample::time));
    const auto left = right - 1;
    const double share = std::log(time / left->time) / std::log(right->time / left->time);
    return left->modulus + share * (right->modulus - left->modulus);
  }
  Eigen::MatrixX3d powers(count, 3);
  Eigen::VectorXd moduli(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double x = std::log(begin[i].time / time) / std::log(reach);
    powers.row(i) << 1.0, x, x * x;
    moduli[i] = begin[i].modulus;
  }
  return powers.colPivHouseholderQr().solve(moduli)[0];
}

}  // namespace breccia
