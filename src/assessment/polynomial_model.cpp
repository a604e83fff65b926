#include "assessment/polynomial_model.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "assessment/observed_value.hpp"
#include "io/collected_mistakes.hpp"
#include "io/display.hpp"

namespace breccia {
namespace {

/// The curve between two neighbours: their indices and the share of the second.
struct Between {
  Eigen::Index first, second;
  double share;
};

/// Where a time or a frequency lies among those of a curve, on a logarithmic axis.
Between between(const std::vector<double>& at, double place) {
  const auto above = std::ranges::upper_bound(at, place);
  const auto second = std::clamp<std::ptrdiff_t>(above - at.begin(), 1, std::ssize(at) - 1);
  const double low = at[static_cast<std::size_t>(second - 1)], high = at[static_cast<std::size_t>(second)];
  return {second - 1, second, std::clamp(std::log(place / low) / std::log(high / low), 0.0, 1.0)};
}

/// A curve at those of its times or frequencies alone that observations lie between.
SampledCurve where_observed(const SampledCurve& curve, const std::vector<Observation>& observations) {
  std::set<Eigen::Index> wanted;
  for (const auto& observation : observations) {
    const auto [first, second, share] = between(curve.at, observation.at);
    wanted.insert({first, second});
  }
  SampledCurve part = {.name = curve.name,
                       .unit = curve.unit,
                       .modulus = curve.modulus,
                       .curve = curve.curve,
                       .share_of_shear = curve.share_of_shear,
                       .at = {},
                       .values = Eigen::MatrixXd(static_cast<Eigen::Index>(wanted.size()), curve.values.cols())};
  for (const auto index : wanted) {
    part.values.row(std::ssize(part.at)) = curve.values.row(index);
    part.at.push_back(curve.at[static_cast<std::size_t>(index)]);
  }
  return part;
}

/// What an observation of the curves of a study over time, or over frequency, may be.
bool is_known(const Observation& observation, bool is_curve_over_frequency) {
  if (is_over_frequency(observation.curve) != is_curve_over_frequency) return false;
  if (is_curve_over_frequency) return true;
  // Young's modulus over time does not follow from G and K at that time alone.
  return observation.curve == ObservedCurve::relaxation && observation.modulus != ObservedModulus::young;
}

}  // namespace

PolynomialModel::PolynomialModel(const std::vector<UncertainInput>& inputs, const AssessmentDesign& design,
                                 std::vector<SampledCurve> curves, std::vector<Observation> observations,
                                 double model_deviation)
    : curves_(std::move(curves)), observations_(std::move(observations)) {
  std::vector<std::string> mistakes;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const auto* const known = std::get_if<Distribution>(&inputs[i].known);
    if (known == nullptr) {
      mistakes.push_back(
          fmt::format("{}: measurements cannot tell one of several values; expected one value, or a "
                      "distribution",
                      inputs[i].name));
      continue;
    }
    components_.push_back({.name = inputs[i].name, .unknown = i, .unit = inputs[i].unit, .prior = *known});
  }
  for (const auto& observation : observations_) {
    if (auto mistake = mistake_in(observation); !mistake.empty()) mistakes.push_back(std::move(mistake));
  }
  refuse_unless_empty(mistakes);
  double largest = 0.0;
  for (auto& curve : curves_) {
    curve = where_observed(curve, observations_);
    const auto& fitted = polynomials_.emplace_back(inputs, followed_samples(design, curve));
    largest = std::max(largest, fitted.mean_square_errors().maxCoeff());
  }
  const double deviation = std::sqrt(model_deviation * model_deviation + largest);
  constexpr double nothing = 1e-6;
  if (!(deviation > nothing)) return;
  factor_ = components_.size();
  components_.push_back({.name = "model", .unknown = inputs.size(), .prior = LogNormal{1.0, 1.0 + deviation}});
}

const SampledCurve* PolynomialModel::curve_of(ObservedModulus modulus, ObservedCurve curve) const {
  const auto found = std::ranges::find_if(
      curves_, [&](const SampledCurve& one) { return one.modulus == modulus && one.curve == curve; });
  return found == curves_.end() ? nullptr : &*found;
}

std::string PolynomialModel::mistake_in(const Observation& observation) const {
  const auto& first = curves_.front();
  const bool has_frequencies = is_over_frequency(first.curve);
  const auto place = has_frequencies ? fmt::format("{:.3g} rad/s", observation.at) : display_time(observation.at);
  if (!is_known(observation, has_frequencies)) {
    return fmt::format("a measurement of the {} modulus, {}, at {}: expected {}", name_of(observation.modulus),
                       name_of(observation.curve), place,
                       has_frequencies ? "dynamic moduli, as the study has them"
                                       : "relaxation moduli in shear or bulk, as the study has them");
  }
  if (observation.modulus != ObservedModulus::shear && curve_of(ObservedModulus::bulk, first.curve) == nullptr) {
    return fmt::format("a measurement of the {} modulus at {}: the study has no test in bulk (tests.loads)",
                       name_of(observation.modulus), place);
  }
  if (observation.temperature) {
    return fmt::format("a measurement at {:.4g} K and {}: expected those at the temperature of the study",
                       *observation.temperature, place);
  }
  constexpr double rounding = 1e-9;
  if (observation.at >= first.at.front() * (1.0 - rounding) && observation.at <= first.at.back() * (1.0 + rounding)) {
    return "";
  }
  return fmt::format("a measurement at {}: outside of the curves of the study", place);
}

PolynomialModel::Curves PolynomialModel::curves_at(const Eigen::VectorXd& scores) const {
  const auto inputs = static_cast<Eigen::Index>(components_.size() - (factor_ ? 1 : 0));
  // Beyond the scores that were sampled polynomials say nothing.
  const Eigen::MatrixXd coordinates = scores.head(inputs).cwiseMax(-most_score).cwiseMin(most_score);
  Curves curves;
  for (const auto& polynomials : polynomials_) curves.emplace_back(polynomials.at(coordinates).col(0));
  return curves;
}

double PolynomialModel::interpolated(const Curves& curves, const SampledCurve& curve, double at) const {
  const auto& values = curves[static_cast<std::size_t>(&curve - curves_.data())];
  const auto [first, second, share] = between(curve.at, at);
  const double value = std::lerp(values[first], values[second], share);
  return curve.curve == ObservedCurve::phase ? value : std::exp(value);
}

std::complex<double> PolynomialModel::modulus_at(const Curves& curves, ObservedModulus modulus, double at) const {
  if (const auto* const absolute = curve_of(modulus, ObservedCurve::absolute)) {
    return std::polar(interpolated(curves, *absolute, at),
                      interpolated(curves, *curve_of(modulus, ObservedCurve::phase), at));
  }
  return interpolated(curves, *curve_of(modulus, ObservedCurve::relaxation), at);
}

double PolynomialModel::predicted(const Curves& curves, const Observation& observation) const {
  const auto shear = modulus_at(curves, ObservedModulus::shear, observation.at);
  std::complex<double> bulk = 0.0;
  if (observation.modulus != ObservedModulus::shear) {
    const auto& tested = *curve_of(ObservedModulus::bulk, curves_.front().curve);
    bulk = modulus_at(curves, ObservedModulus::bulk, observation.at) - tested.share_of_shear * shear;
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

Eigen::VectorXd PolynomialModel::predictions(const Eigen::VectorXd& scores) const {
  const auto curves = curves_at(scores);
  Eigen::VectorXd values(static_cast<Eigen::Index>(observations_.size()));
  for (std::size_t i = 0; i < observations_.size(); ++i) {
    auto& value = values[static_cast<Eigen::Index>(i)];
    value = predicted(curves, observations_[i]);
    if (!factor_ || observations_[i].curve == ObservedCurve::phase) continue;
    value *= value_at_score(components_[*factor_].prior, scores[static_cast<Eigen::Index>(*factor_)]);
  }
  return values;
}

Eigen::MatrixXd PolynomialModel::jacobian(const Eigen::VectorXd& scores) const {
  constexpr double step = 1e-3;
  Eigen::MatrixXd jacobian(static_cast<Eigen::Index>(observations_.size()), size());
  for (Eigen::Index column = 0; column < size(); ++column) {
    const Eigen::VectorXd move = step * Eigen::VectorXd::Unit(size(), column);
    jacobian.col(column) = (deviations(scores + move) - deviations(scores - move)) / (2.0 * step);
  }
  return jacobian;
}

}  // namespace breccia
