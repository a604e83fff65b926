#include "breccia/study/measurement.hpp"

#include <algorithm>
#include <cmath>

namespace breccia {
namespace {

/// Whether a time lies in a window, but for rounding.
bool is_within(const TimeWindow& window, double time) {
  constexpr double rounding = 1e-9;
  return window.begin * (1.0 - rounding) <= time && time <= window.end * (1.0 + rounding);
}

}  // namespace

std::optional<TimeWindow> Measurement::known_within(const TimeWindow& window) const {
  TimeWindow known = window;
  const auto cut = [&known](const TimeWindow& to) {
    known = {std::max(known.begin, to.begin), std::min(known.end, to.end)};
  };
  if (const auto* curve = std::get_if<Curve>(&modulus)) cut({curve->front().time, curve->back().time});
  if (times) cut(*times);
  return known.begin <= known.end ? std::optional(known) : std::nullopt;
}

std::vector<double> Measurement::points_within(const TimeWindow& window) const {
  std::vector<double> points;
  for (const auto& one : dynamic) points.push_back(1.0 / one.angular_frequency);
  if (const auto* curve = std::get_if<Curve>(&modulus)) {
    for (const auto& sample : *curve) points.push_back(sample.time);
  }
  const auto known = known_within(window);
  std::erase_if(points, [&known](double time) { return !known || !is_within(*known, time); });
  return points;
}

std::vector<MeasuredModulus> Measurement::complex_within(const TimeWindow& window,
                                                         const std::vector<double>& angular_frequencies) const {
  const auto known = known_within(window);
  if (!known) return {};
  auto moduli = dynamic;
  const auto* series = std::get_if<PronySeries>(&modulus);
  if (moduli.empty() && series != nullptr && !series->is_elastic()) {
    for (const double omega : angular_frequencies) {
      const auto there = series->complex_modulus(omega);
      moduli.push_back({omega, there.real(), there.imag()});
    }
  }
  std::erase_if(moduli, [&](const MeasuredModulus& one) { return !is_within(*known, 1.0 / one.angular_frequency); });
  return moduli;
}

double Measurement::at(double time) const {
  if (const auto* series = std::get_if<PronySeries>(&modulus)) return series->at(time);
  const auto& curve = std::get<Curve>(modulus);
  const auto right = std::max(curve.begin() + 1, std::ranges::lower_bound(curve, time, {}, &Sample::time));
  const auto left = right - 1;
  const double share = std::log(time / left->time) / std::log(right->time / left->time);
  return left->modulus * std::pow(right->modulus / left->modulus, share);
}

}  // namespace breccia
