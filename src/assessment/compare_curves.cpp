#include "breccia/assessment/compare_curves.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/assessment/calibrate_inputs.hpp"
#include "breccia/error.hpp"

#include "assessment/curve_values.hpp"

namespace breccia {
namespace {

constexpr double rounding = 1e-9;

const SampledCurve* curve_named(const std::vector<SampledCurve>& curves, const std::string& name) {
  const auto found = std::ranges::find(curves, name, &SampledCurve::name);
  return found == curves.end() ? nullptr : &*found;
}

/// The error of a curve between two of its times: the larger one, or nothing where one is not known.
std::optional<double> error_at(const SampledCurve& curve, const Between& place) {
  const auto first = curve.errors[static_cast<std::size_t>(place.first)];
  const auto second = curve.errors[static_cast<std::size_t>(place.second)];
  if (place.share <= rounding) return first;
  if (place.share >= 1.0 - rounding) return second;
  return first && second ? std::optional(std::max(*first, *second)) : std::nullopt;
}

/// The curves of one name of all composites at the times of the first that all have, and at the ends of what all have;
/// at none where they share no time.
ComparedCurve side_by_side(const std::vector<const SampledCurve*>& curves) {
  const auto& first = *curves.front();
  ComparedCurve compared = {.name = first.name,
                            .unit = first.unit,
                            .modulus = first.modulus,
                            .share_of_shear = first.share_of_shear,
                            .curve = first.curve};
  double begin = 0.0, end = std::numeric_limits<double>::infinity();
  for (const auto* curve : curves) {
    begin = std::max(begin, curve->at.front());
    end = std::min(end, curve->at.back());
  }
  if (begin > end * (1.0 + rounding)) return compared;
  compared.at.push_back(begin);
  for (const double place : first.at) {
    if (place > begin * (1.0 + rounding) && place < end * (1.0 - rounding)) compared.at.push_back(place);
  }
  if (end > begin * (1.0 + rounding)) compared.at.push_back(end);
  compared.values = Eigen::MatrixXd(std::ssize(compared.at), std::ssize(curves));
  for (std::size_t composite = 0; composite < curves.size(); ++composite) {
    const auto& curve = *curves[composite];
    const auto values = values_of_sample({curve}, 0).front();
    auto& errors = compared.errors.emplace_back();
    for (std::size_t i = 0; i < compared.at.size(); ++i) {
      compared.values(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(composite)) =
          interpolated(curve, values, compared.at[i]);
      errors.push_back(error_at(curve, between(curve.at, compared.at[i])));
    }
  }
  return compared;
}

std::vector<std::string> names_of(const std::vector<SampledCurve>& curves) {
  std::vector<std::string> names;
  names.reserve(curves.size());
  for (const auto& curve : curves) names.push_back(curve.name);
  return names;
}

}  // namespace

bool CurveDifference::is_beyond_error() const {
  return error && std::abs(std::log(value)) > std::log1p(*error);
}

ComparedCurves compare_curves(const std::vector<std::vector<SampledCurve>>& composites) {
  ComparedCurves compared;
  for (const auto& curve : composites.front()) {
    std::vector<const SampledCurve*> same;
    same.reserve(composites.size());
    for (const auto& curves : composites) same.push_back(curve_named(curves, curve.name));
    if (std::ranges::find(same, nullptr) != same.end()) continue;
    auto one = side_by_side(same);
    if (one.at.empty()) {
      throw InputError(fmt::format("the results share no {}", is_over_frequency(curve.curve) ? "frequency" : "time"));
    }
    compared.curves.push_back(std::move(one));
  }
  for (const auto& curves : composites) {
    for (const auto& name : names_of(curves)) {
      const bool is_compared = std::ranges::find(compared.curves, name, &ComparedCurve::name) != compared.curves.end();
      const bool is_known = std::ranges::find(compared.left_out, name) != compared.left_out.end();
      if (!is_compared && !is_known) compared.left_out.push_back(name);
    }
  }
  if (!compared.curves.empty()) return compared;
  std::vector<std::string> all;
  all.reserve(composites.size());
  for (const auto& curves : composites) all.push_back(fmt::format("{}", fmt::join(names_of(curves), ", ")));
  throw InputError(
      fmt::format("the results have no curve in common; they have, in their order: {}", fmt::join(all, "; ")));
}

CurveDifference difference_from_first(const ComparedCurve& curve, std::size_t composite, std::size_t place) {
  const auto row = static_cast<Eigen::Index>(place);
  const double first = curve.values(row, 0), other = curve.values(row, static_cast<Eigen::Index>(composite));
  if (curve.curve == ObservedCurve::phase) return {.value = other - first};
  CurveDifference difference = {.value = other / first};
  const auto &of_first = curve.errors[0][place], &of_other = curve.errors[composite][place];
  if (of_first && of_other) difference.error = std::hypot(*of_first, *of_other);
  return difference;
}

std::vector<Observation> comparable_values(const std::vector<Observation>& measured,
                                           const std::vector<SampledCurve>& curves) {
  const auto& first = curves.front();
  require_observable({}, measured,
                     {.are_over_frequency = is_over_frequency(first.curve),
                      .have_bulk = curve_of(curves, ObservedModulus::bulk, first.curve) != nullptr,
                      .first = 0.0,
                      .last = std::numeric_limits<double>::infinity()});
  std::vector<Observation> values;
  for (const auto& one : measured) {
    if (one.curve != ObservedCurve::storage && one.curve != ObservedCurve::loss) {
      values.push_back(one);
      continue;
    }
    if (one.curve == ObservedCurve::loss) continue;
    const auto loss = std::ranges::find_if(measured, [&](const Observation& other) {
      return other.curve == ObservedCurve::loss && other.modulus == one.modulus && other.at == one.at;
    });
    if (loss == measured.end()) continue;
    auto absolute = one;
    absolute.curve = ObservedCurve::absolute;
    absolute.value = std::hypot(one.value, loss->value);
    values.push_back(absolute);
  }
  return values;
}

std::vector<Observation> values_within(const std::vector<Observation>& measured, const ComparedCurve& compared) {
  std::vector<Observation> within;
  std::ranges::copy_if(measured, std::back_inserter(within), [&](const Observation& one) {
    return one.at >= compared.at.front() * (1.0 - rounding) && one.at <= compared.at.back() * (1.0 + rounding);
  });
  return within;
}

MeasuredDeviation deviation_from(const std::vector<Observation>& measured, const std::vector<SampledCurve>& curves) {
  const auto values = values_of_sample(curves, 0);
  MeasuredDeviation deviation = {
      .count = measured.size(), .least = std::numeric_limits<double>::infinity(), .most = 0.0};
  for (const auto& one : measured) {
    const double ratio = observed_value(curves, values, one) / one.value;
    deviation.rms += std::pow(std::log(ratio), 2) / static_cast<double>(measured.size());
    if (ratio < deviation.least) {
      deviation.least = ratio;
      deviation.at_least = one.at;
    }
    if (ratio > deviation.most) {
      deviation.most = ratio;
      deviation.at_most = one.at;
    }
  }
  deviation.rms = std::sqrt(deviation.rms);
  return deviation;
}

}  // namespace breccia
