#pragma once

#include <vector>

#include <Eigen/Core>

#include "breccia/assessment/observation.hpp"

#include "assessment/unknown_vector.hpp"

namespace breccia {

/// Predictions of what was observed as functions of the scores of unknowns.
class PredictiveModel {
 public:
  PredictiveModel() = default;
  PredictiveModel(const PredictiveModel&) = delete;
  PredictiveModel& operator=(const PredictiveModel&) = delete;
  PredictiveModel(PredictiveModel&&) = delete;
  PredictiveModel& operator=(PredictiveModel&&) = delete;
  virtual ~PredictiveModel() = default;

  /// The unknowns, the factors by which composites differ from their models among them.
  [[nodiscard]] virtual const std::vector<UnknownComponent>& components() const noexcept = 0;
  [[nodiscard]] virtual const std::vector<Observation>& observations() const noexcept = 0;
  /// The predicted values, in the units of the observations.
  [[nodiscard]] virtual Eigen::VectorXd predictions(const Eigen::VectorXd& scores) const = 0;
  /// The derivatives of the deviations by the scores: observations x unknowns.
  [[nodiscard]] virtual Eigen::MatrixXd jacobian(const Eigen::VectorXd& scores) const = 0;

  [[nodiscard]] Eigen::Index size() const noexcept { return static_cast<Eigen::Index>(components().size()); }
  /// The predictions minus the observations in standard deviations: of logarithms, and of phases as they are.
  [[nodiscard]] Eigen::VectorXd deviations(const Eigen::VectorXd& scores) const;
};

}  // namespace breccia
