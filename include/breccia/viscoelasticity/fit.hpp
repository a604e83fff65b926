#pragma once

#include <span>
#include <vector>

#include "breccia/viscoelasticity/creep_compliance.hpp"
#include "breccia/viscoelasticity/prony_series.hpp"

namespace breccia {

struct FitOptions {
  /// Relaxation or retardation times among which a fit chooses. It takes one or two a decade of them; a grid as sparse
  /// as that would miss the times of a spectrum of few terms by up to 4 % of the modulus.
  double times_per_decade = 10.0;
  /// Duration [s] of the constant-rate ramp in which strain (or stress) was applied, times counted from its beginning;
  /// 0: a step. The fit is to the answer to the ramp, so that data from its first moment on count (theory, Eq. 26).
  double ramp = 0.0;
};

/// How well a fit meets its data; all relative to the data.
struct FitQuality {
  double median_error = 0.0;            ///< of the absolute deviations [-]
  double worst_error = 0.0;             ///< [-]
  double worst_at = 0.0;                ///< time [s] or angular frequency [rad/s] of the worst
  std::vector<double> fitted;           ///< what the fit says at each datum, in the data's unit
  std::vector<double> standard_errors;  ///< of the fit at each datum, from the scatter of the data [-]
};

struct RelaxationFit {
  PronySeries series;
  FitQuality quality;
};

struct CreepFit {
  CreepCompliance compliance;
  FitQuality quality;
};

/// Fits with non-negative spectra at logarithmic times over the range of the data, in the least squares of the relative
/// deviations. All throw InputError when the data are fewer than three, out of order, or not positive, and
/// NumericalError when a fit does not converge.
RelaxationFit fit_relaxation(std::span<const double> times, std::span<const double> moduli,
                             const FitOptions& options = {});
CreepFit fit_creep(std::span<const double> times, std::span<const double> compliances, const FitOptions& options = {});

/// From storage and loss modulus [Pa] at angular frequencies [rad/s]. The quality is first that of the storage, then
/// that of the loss moduli.
RelaxationFit fit_dynamic(std::span<const double> frequencies, std::span<const double> storage,
                          std::span<const double> loss, const FitOptions& options = {});

}  // namespace breccia
