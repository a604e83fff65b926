#pragma once

#include <vector>

#include "breccia/viscoelasticity/fit.hpp"

namespace breccia {

/// Storage and loss modulus measured at one temperature.
struct FrequencySweep {
  double temperature = 0.0;              ///< [K]
  std::vector<double> frequencies = {};  ///< angular [rad/s], rising
  std::vector<double> storage = {};      ///< [Pa]
  std::vector<double> loss = {};         ///< [Pa]
};

/// Shift of one sweep along the axis of log frequency.
struct ShiftFactor {
  double temperature = 0.0;     ///< [K]
  double log10_factor = 0.0;    ///< log10 a_T [-]; 0 at the reference
  double standard_error = 0.0;  ///< of log10 a_T, from the scatter of the data [-]
};

/// Sweeps at several temperatures as one at the reference temperature.
struct MasterCurve {
  double reference_temperature = 0.0;           ///< [K]
  std::vector<ShiftFactor> shift_factors = {};  ///< one a sweep, by rising temperature
  std::vector<double> frequencies = {};         ///< reduced, a_T omega [rad/s], rising
  std::vector<double> storage = {};             ///< [Pa], at these
  std::vector<double> loss = {};                ///< [Pa], at these
  RelaxationFit fit = {};                       ///< at the reference temperature
};

/// Shifts sweeps so that one non-negative spectrum meets the storage and loss moduli of all best, in the least squares
/// of the relative deviations. The shifts are the only non-linear unknowns: the spectrum is the best for each trial of
/// them (variable projection; Golub and Pereyra, Inverse Problems 19, R1, 2003), and Levenberg and Marquardt's method
/// finds them, from a start at which storage moduli of neighbouring temperatures meet. Moduli are not shifted
/// vertically. The reference must be the temperature of a sweep, to 0.01 K; two sweeps need not have the same
/// frequencies.
/// Throws InputError when the data are bad, two sweeps have one temperature or the moduli of neighbours do not overlap,
/// NumericalError when there is no convergence.
MasterCurve master_curve(std::vector<FrequencySweep> sweeps, double reference_temperature,
                         const FitOptions& options = {});

}  // namespace breccia
