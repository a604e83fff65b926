#include "breccia/study/measurement.hpp"

#include <algorithm>
#include <cmath>

namespace breccia {

std::optional<TimeWindow> Measurement::known_within(const TimeWindow& window) const {
  TimeWindow known = window;
  const auto cut = [&known](const TimeWindow& to) {
    known = {std::max(known.begin, to.begin), std::min(known.end, to.end)};
  };
  if (const auto* curve = std::get_if<Curve>(&shear)) cut({curve->front().time, curve->back().time});
  if (times) cut(*times);
  return known.begin <= known.end ? std::optional(known) : std::nullopt;
}

double Measurement::at(double time) const {
  if (const auto* series = std::get_if<PronySeries>(&shear)) return series->at(time);
  const auto& curve = std::get<Curve>(shear);
  const auto right = std::max(curve.begin() + 1, std::ranges::lower_bound(curve, time, {}, &Sample::time));
  const auto left = right - 1;
  const double share = std::log(time / left->time) / std::log(right->time / left->time);
  return left->modulus * std::pow(right->modulus / left->modulus, share);
}

}  // namespace breccia
