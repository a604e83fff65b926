#pragma once

#include <span>
#include <vector>

#include "breccia/viscoelasticity/creep_compliance.hpp"
#include "breccia/viscoelasticity/prony_series.hpp"

namespace breccia {

/// Settings of a fit.
struct FitOptions {
  /// Candidates for the relaxation or retardation times, per decade. A fit keeps one or two of them per decade; if the
  /// grid had only as many candidates, it would miss the times of a spectrum of few terms, with errors of up to 4 % of
  /// the modulus.
  double times_per_decade = 10.0;
  /// Duration [s] of the constant-rate ramp by which strain (or stress) was applied; 0 stands for a step. Times count
  /// from the beginning of the ramp. The response to the ramp is fitted, so that data taken during it can be used
  /// (theory, Eq. 26).
  double ramp = 0.0;
};

/// Deviations of a fit from its data, relative to the data.
struct FitQuality {
  double median_error = 0.0;   ///< median of the absolute deviations [-]
  double worst_error = 0.0;    ///< largest absolute deviation [-]
  double worst_at = 0.0;       ///< time [s] or angular frequency [rad/s] of this deviation
  std::vector<double> fitted;  ///< values of the fit at the data points, in the unit of the data
  /// Relative standard errors of the fit at each data point, from the scatter of the data [-]; NaN where the fit has as
  /// many parts as there are data.
  std::vector<double> standard_errors;
};

/// A relaxation modulus fitted to data.
struct RelaxationFit {
  PronySeries series;
  FitQuality quality;
};

/// A creep compliance fitted to data.
struct CreepFit {
  CreepCompliance compliance;
  FitQuality quality;
};

/// Fits a relaxation modulus to moduli [Pa] at rising times [s]: a non-negative spectrum at logarithmic times over the
/// range of the data, by least squares of the relative deviations. Throws InputError when there are fewer than three
/// data points, or they are out of order or not positive, and NumericalError when the fit does not converge.
RelaxationFit fit_relaxation(std::span<const double> times, std::span<const double> moduli,
                             const FitOptions& options = {});
/// Fits a creep compliance to compliances [1/Pa] at rising times [s] in the same way. Throws as fit_relaxation().
CreepFit fit_creep(std::span<const double> times, std::span<const double> compliances, const FitOptions& options = {});

/// Fits a relaxation modulus to storage and loss moduli [Pa] at rising angular frequencies [rad/s] in the same way. The
/// quality lists the storage moduli first, then the loss moduli. Throws as fit_relaxation().
RelaxationFit fit_dynamic(std::span<const double> frequencies, std::span<const double> storage,
                          std::span<const double> loss, const FitOptions& options = {});

}  // namespace breccia
