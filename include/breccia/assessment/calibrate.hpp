#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "breccia/assessment/interval.hpp"
#include "breccia/assessment/observation.hpp"
#include "breccia/assessment/unknown.hpp"
#include "breccia/viscoelasticity/shifted_material.hpp"

namespace breccia {

/// Whether the standard deviations of measurements are known, or only their ratios to each other.
enum class Noise { known, relative };

/// How a calibration describes the posterior.
struct CalibrationOptions {
  Noise noise = Noise::relative;
  /// Number of samples that are drawn from the posterior by an ensemble sampler; 0: the normal distribution about its
  /// mode is taken.
  int samples = 0;
};

/// What a calibration has found of an unknown number, in SI units.
struct Estimate {
  std::string name = {};  ///< "hmx.shear", "binder.spectrum at 1 us", "model of pbx"
  std::string unit = {};  ///< SI unit of the value; empty without one
  Distribution prior = {};
  double value = 0.0;      ///< the median
  Interval interval = {};  ///< 95 % of the posterior lie in it
  double score = 0.0;      ///< the score of the median in the prior
  double deviation = 1.0;  ///< standard deviation of the score a posteriori; 1 a priori, less within a spectrum
  /// The share of the variance of the score that the data have removed: 0 where only the prior is known, 1 where only
  /// the data matter.
  double learned = 0.0;
};

/// A measurement beside its prediction.
struct PredictedObservation {
  double value = 0.0;      ///< predicted, in the unit of the observation
  Interval interval = {};  ///< 95 % of the predictions of the unknowns, without the noise of the measurement
  double deviation = 0.0;  ///< measured minus predicted, in standard deviations of the noise
};

/// The result of a calibration.
struct Calibration {
  std::vector<Estimate> estimates = {};                ///< of the unknowns, then of the factors of the composites
  Eigen::MatrixXd correlation = {};                    ///< of the scores of the estimates
  std::vector<PredictedObservation> predictions = {};  ///< by observation
  std::vector<ShiftedMaterial> materials = {};         ///< the materials that were changed, at the values found
  double noise = 1.0;       ///< factor of the stated standard deviations that the data show; 1 where these are known
  double misfit = 0.0;      ///< sum of the squared deviations, in units of the noise
  double determined = 0.0;  ///< number of unknowns that the data determine
  bool has_converged = false;
  /// Number of independent samples from which the intervals are, NaN where there are too few samples to tell it;
  /// nothing of the normal distribution.
  std::optional<double> independent_samples = {};
  /// Materials that were found, or are at the end of an interval, outside of what a run has sampled.
  std::vector<std::string> warnings = {};
  /// What the data say of the unknowns and of the model, a line each.
  std::vector<std::string> remarks = {};
};

/// Finds unknown numbers of the materials of composites from measurements, by Bayes' rule: the most likely scores of
/// the unknowns, and the normal distribution about them or samples (theory, section 19). Throws InputError for mistakes
/// in the unknowns, the composites or the observations, and where noise that is not known cannot be told from so few
/// data; NumericalError where no mode is found.
Calibration calibrate(const std::vector<ObservedComposite>& composites, const std::vector<Unknown>& unknowns,
                      const std::vector<Observation>& observations, const CalibrationOptions& options);

}  // namespace breccia
