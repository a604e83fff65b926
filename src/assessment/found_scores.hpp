#pragma once

#include <Eigen/Core>

#include "breccia/assessment/calibrate.hpp"

#include "assessment/predictive_model.hpp"

namespace breccia {

/// What is known of the scores of unknowns beforehand: they are normal about zero, and in addition the components of a
/// matrix times the scores, with a deviation that is not known (InverseProblem).
struct PriorOfScores {
  Eigen::VectorXd deviations;  ///< standard deviation of each score
  Eigen::MatrixXd curvature;   ///< with a column for each score and any number of rows
};

/// What was found of the scores.
struct FoundScores {
  Eigen::VectorXd middle;        ///< the most likely scores or, of samples, their medians
  Calibration calibration = {};  ///< without materials and warnings
};

/// Finds the scores of the unknowns of a model from its observations (calibrate). Throws InputError where noise that is
/// not known cannot be told from so few data; NumericalError where no mode is found.
FoundScores find_scores(const PredictiveModel& model, const PriorOfScores& prior, const CalibrationOptions& options);

}  // namespace breccia
