#include "assessment/polynomial_model.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include "breccia/assessment/calibrate_inputs.hpp"

#include "assessment/observed_value.hpp"

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

}  // namespace

PolynomialModel::PolynomialModel(const std::vector<UncertainInput>& inputs, const AssessmentDesign& design,
                                 std::vector<SampledCurve> curves, std::vector<Observation> observations,
                                 double model_deviation)
    : curves_(std::move(curves)), observations_(std::move(observations)) {
  const auto& first = curves_.front();
  require_observable(inputs, observations_,
                     {.are_over_frequency = is_over_frequency(first.curve),
                      .have_bulk = curve_of(ObservedModulus::bulk, first.curve) != nullptr,
                      .first = first.at.front(),
                      .last = first.at.back()});
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    components_.push_back({.name = inputs[i].name,
                           .unknown = i,
                           .unit = inputs[i].unit,
                           .prior = std::get<Distribution>(inputs[i].known)});
  }
  double of_moduli = 0.0, of_phases = 0.0;
  for (auto& curve : curves_) {
    curve = where_observed(curve, observations_);
    const auto& fitted = polynomials_.emplace_back(inputs, followed_samples(design, curve));
    auto& largest = curve.curve == ObservedCurve::phase ? of_phases : of_moduli;
    largest = std::max(largest, fitted.mean_square_errors().maxCoeff());
  }
  add_errors_of_phases(std::sqrt(of_phases));
  const double deviation = std::sqrt(model_deviation * model_deviation + of_moduli);
  constexpr double nothing = 1e-6;
  if (!(deviation > nothing)) return;
  factor_ = components_.size();
  components_.push_back({.name = "model", .unknown = inputs.size(), .prior = LogNormal{1.0, 1.0 + deviation}});
}

/// An error of the phase [rad] is one of a loss modulus over tan(phase), and of a storage modulus times that.
void PolynomialModel::add_errors_of_phases(double error) {
  if (!(error > 0.0)) return;
  const auto curves = curves_at(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(components_.size())));
  for (auto& observation : observations_) {
    const auto modulus = modulus_at(curves, ObservedModulus::shear, observation.at);
    const double tangent = modulus.imag() / modulus.real();
    double own = 0.0;
    if (observation.curve == ObservedCurve::phase) own = error;
    if (observation.curve == ObservedCurve::loss) own = error / tangent;
    if (observation.curve == ObservedCurve::storage) own = error * tangent;
    observation.deviation = std::hypot(observation.deviation, own);
  }
}

const SampledCurve* PolynomialModel::curve_of(ObservedModulus modulus, ObservedCurve curve) const {
  const auto found = std::ranges::find_if(
      curves_, [&](const SampledCurve& one) { return one.modulus == modulus && one.curve == curve; });
  return found == curves_.end() ? nullptr : &*found;
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
