#include "assessment/polynomial_model.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include "breccia/assessment/calibrate_inputs.hpp"

#include "assessment/curve_values.hpp"

namespace breccia {
namespace {

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
                      .have_bulk = curve_of(curves_, ObservedModulus::bulk, first.curve) != nullptr,
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
  const auto values = values_at(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(components_.size())));
  for (auto& observation : observations_) {
    const auto modulus = modulus_at(curves_, values, ObservedModulus::shear, observation.at);
    const double tangent = modulus.imag() / modulus.real();
    double own = 0.0;
    if (observation.curve == ObservedCurve::phase) own = error;
    if (observation.curve == ObservedCurve::loss) own = error / tangent;
    if (observation.curve == ObservedCurve::storage) own = error * tangent;
    observation.deviation = std::hypot(observation.deviation, own);
  }
}

CurveValues PolynomialModel::values_at(const Eigen::VectorXd& scores) const {
  const auto inputs = static_cast<Eigen::Index>(components_.size() - (factor_ ? 1 : 0));
  // Beyond the scores that were sampled polynomials say nothing.
  const Eigen::MatrixXd coordinates = scores.head(inputs).cwiseMax(-most_score).cwiseMin(most_score);
  CurveValues values;
  for (const auto& polynomials : polynomials_) values.emplace_back(polynomials.at(coordinates).col(0));
  return values;
}

Eigen::VectorXd PolynomialModel::predictions(const Eigen::VectorXd& scores) const {
  const auto curve_values = values_at(scores);
  Eigen::VectorXd values(static_cast<Eigen::Index>(observations_.size()));
  for (std::size_t i = 0; i < observations_.size(); ++i) {
    auto& value = values[static_cast<Eigen::Index>(i)];
    value = observed_value(curves_, curve_values, observations_[i]);
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
