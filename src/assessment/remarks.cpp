#include "assessment/remarks.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <tuple>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/display.hpp"

namespace breccia {
namespace {

/// Where an observation was made: "at 3 ms", "at 20 rad/s".
std::string place_of(const Observation& observation) {
  return is_over_frequency(observation.curve) ? fmt::format("at {:.3g} rad/s", observation.at)
                                              : fmt::format("at {}", display_time(observation.at));
}

/// The relative difference of a measured value from the prediction; of a phase, in radians.
double difference(const Observation& observation, const PredictedObservation& predicted) {
  if (observation.curve == ObservedCurve::phase) return observation.value - predicted.value;
  return observation.value / predicted.value - 1.0;
}

std::string remark_on_differences(const Calibration& calibration, const std::vector<Observation>& observations) {
  double squares = 0.0, worst = 0.0;
  std::size_t at = 0;
  for (std::size_t i = 0; i < observations.size(); ++i) {
    const double one = difference(observations[i], calibration.predictions[i]);
    squares += one * one;
    if (std::abs(one) < std::abs(worst)) continue;
    worst = one;
    at = i;
  }
  return fmt::format("measured minus predicted: {:.2g} % root mean square, {:+.2g} % at most, {}",
                     100.0 * std::sqrt(squares / static_cast<double>(observations.size())), 100.0 * worst,
                     place_of(observations[at]));
}

/// The deviations of each measured curve, of a composite at a temperature, by rising time or frequency.
std::vector<std::vector<double>> deviations_of_curves(const Calibration& calibration,
                                                      const std::vector<Observation>& observations) {
  std::map<std::tuple<std::size_t, ObservedModulus, ObservedCurve, double>, std::map<double, double>> curves;
  for (std::size_t i = 0; i < observations.size(); ++i) {
    const auto& one = observations[i];
    curves[{one.composite, one.modulus, one.curve, one.temperature.value_or(0.0)}][one.at] =
        calibration.predictions[i].deviation;
  }
  std::vector<std::vector<double>> deviations;
  for (const auto& [key, curve] : curves) {
    auto& of_curve = deviations.emplace_back();
    for (const auto& [at, deviation] : curve) of_curve.push_back(deviation);
  }
  return deviations;
}

/// A remark where the deviations of neighbouring measurements are alike: the ratio of the squares of their differences
/// to their squares, 2 of independent deviations, is as small by chance once in a hundred times (von Neumann, Ann.
/// Math. Stat. 12, 367, 1941).
std::string remark_on_neighbours(const Calibration& calibration, const std::vector<Observation>& observations) {
  double squares = 0.0, differences = 0.0, pairs = 0.0;
  for (const auto& curve : deviations_of_curves(calibration, observations)) {
    for (std::size_t i = 1; i < curve.size(); ++i) {
      squares += 0.5 * (std::pow(curve[i], 2) + std::pow(curve[i - 1], 2));
      differences += std::pow(curve[i] - curve[i - 1], 2);
      pairs += 1.0;
    }
  }
  constexpr double far = 2.33;
  if (pairs == 0.0 || differences >= (2.0 - 2.0 * far / std::sqrt(pairs)) * squares) return "";
  return "the deviations are no scatter: neighbouring ones are alike, so that the model does not follow the data with "
         "these unknowns, and the intervals are too narrow";
}

std::string remark_on_misfit(const Calibration& calibration, std::size_t observations) {
  const double free = std::max(1.0, static_cast<double>(observations) - calibration.determined);
  constexpr double much = 3.0;
  if (calibration.misfit < free + much * std::sqrt(2.0 * free)) return "";
  return fmt::format(
      "no values of these unknowns explain the data within their noise: the deviations are {:.2g} times as large",
      std::sqrt(calibration.misfit / free));
}

std::vector<std::string> remarks_on_pairs(const Calibration& calibration) {
  constexpr double strong = 0.9;
  std::vector<std::string> pairs;
  const auto& estimates = calibration.estimates;
  for (std::size_t i = 0; i < estimates.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double one = calibration.correlation(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
      const bool are_terms = estimates[i].name.find(".spectrum at ") != std::string::npos &&
                             estimates[j].name.find(".spectrum at ") != std::string::npos;
      if (std::abs(one) < strong || are_terms) continue;
      pairs.push_back(fmt::format("the data hardly separate {} from {}: correlation {:+.2f}", estimates[j].name,
                                  estimates[i].name, one));
    }
  }
  return pairs;
}

/// A remark where the factor of a model is further from 1 than its error allows.
std::vector<std::string> remarks_on_models(const Calibration& calibration) {
  constexpr double far = 2.5;
  std::vector<std::string> remarks;
  for (const auto& one : calibration.estimates) {
    if (!one.name.starts_with("model of ") || std::abs(one.score) < far) continue;
    remarks.push_back(fmt::format(
        "the {} is off by more than its error allows: an unknown may be missing, or the error of the model is larger",
        one.name));
  }
  return remarks;
}

std::string remark_on_unlearned(const Calibration& calibration) {
  constexpr double little = 0.1;
  std::vector<std::string> names;
  for (const auto& one : calibration.estimates) {
    if (one.learned < little && !one.name.starts_with("model of ")) names.push_back(one.name);
  }
  if (names.empty()) return "";
  return fmt::format("the data say nothing of {}: only what was assumed is known", fmt::join(names, ", "));
}

}  // namespace

std::vector<std::string> remarks_on(const Calibration& calibration, const std::vector<Observation>& observations,
                                    Noise noise) {
  std::vector<std::string> remarks = {remark_on_differences(calibration, observations)};
  if (noise == Noise::relative) {
    remarks.push_back(fmt::format("noise of the data: {:.2g} %, as their deviations show",
                                  100.0 * calibration.noise * observations.front().deviation));
  } else {
    remarks.push_back(remark_on_misfit(calibration, observations.size()));
  }
  remarks.push_back(remark_on_neighbours(calibration, observations));
  std::ranges::copy(remarks_on_pairs(calibration), std::back_inserter(remarks));
  std::ranges::move(remarks_on_models(calibration), std::back_inserter(remarks));
  remarks.push_back(remark_on_unlearned(calibration));
  if (const auto& samples = calibration.independent_samples) {
    constexpr double few = 100.0;
    if (std::isnan(*samples)) {
      remarks.emplace_back(
          "the samples are too few to estimate how many of them are independent: the intervals may be those of the "
          "normal "
          "distribution, from which they start; draw more of them");
    } else {
      remarks.push_back(fmt::format("intervals from {:.0f} independent samples{}", *samples,
                                    *samples < few ? ": too few for the ends of intervals of 95 %" : ""));
    }
  }
  if (!calibration.has_converged) remarks.emplace_back("the search has not converged: the values are the best so far");
  std::erase(remarks, "");
  return remarks;
}

}  // namespace breccia
