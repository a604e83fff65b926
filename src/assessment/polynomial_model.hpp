#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "breccia/assessment/assess.hpp"
#include "breccia/assessment/observation.hpp"

#include "assessment/curve_values.hpp"
#include "assessment/polynomial_chaos.hpp"
#include "assessment/predictive_model.hpp"

namespace breccia {

/// Predictions by polynomials in the uncertain inputs of a study, which follow the curves of its samples. The unknowns
/// are the inputs, then a factor by which the composite differs from its model at all times, where one is given.
class PolynomialModel final : public PredictiveModel {
 public:
  /// `model_deviation` is the relative standard deviation of the model, to which the error of the polynomials is
  /// added; that of phases is added to the noise.
  /// Throws InputError as require_observable().
  PolynomialModel(const std::vector<UncertainInput>& inputs, const AssessmentDesign& design,
                  std::vector<SampledCurve> curves, std::vector<Observation> observations, double model_deviation);

  [[nodiscard]] const std::vector<UnknownComponent>& components() const noexcept override { return components_; }
  [[nodiscard]] const std::vector<Observation>& observations() const noexcept override { return observations_; }
  [[nodiscard]] Eigen::VectorXd predictions(const Eigen::VectorXd& scores) const override;
  /// By central differences.
  [[nodiscard]] Eigen::MatrixXd jacobian(const Eigen::VectorXd& scores) const override;

 private:
  void add_errors_of_phases(double error);
  [[nodiscard]] CurveValues values_at(const Eigen::VectorXd& scores) const;

  std::vector<UnknownComponent> components_;
  std::vector<SampledCurve> curves_;
  std::vector<PolynomialChaos> polynomials_;  ///< by curve
  std::vector<Observation> observations_;
  std::optional<std::size_t> factor_ = {};  ///< component of the factor of the model
};

}  // namespace breccia
