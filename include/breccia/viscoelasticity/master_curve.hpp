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

/// Shift of one frequency sweep along the axis of log frequency.
struct ShiftFactor {
  double temperature = 0.0;     ///< [K]
  double log10_factor = 0.0;    ///< log10 a_T [-]; 0 at the reference
  double standard_error = 0.0;  ///< standard error of log10 a_T, from the scatter of the data [-]
};

/// Frequency sweeps at several temperatures, shifted to the reference temperature.
struct MasterCurve {
  double reference_temperature = 0.0;           ///< [K]
  std::vector<ShiftFactor> shift_factors = {};  ///< one per sweep, by rising temperature
  std::vector<double> frequencies = {};         ///< reduced angular frequencies a_T omega [rad/s], rising
  std::vector<double> storage = {};             ///< storage modulus at these frequencies [Pa]
  std::vector<double> loss = {};                ///< loss modulus at these frequencies [Pa]
  RelaxationFit fit = {};                       ///< relaxation modulus at the reference temperature
};

/// Shifts frequency sweeps so that one non-negative spectrum fits the storage and loss moduli of all of them, by least
/// squares of the relative deviations. The shifts are the only non-linear unknowns: for each trial of the shifts the
/// best spectrum is computed (variable projection; Golub and Pereyra, Inverse Problems 19, R1, 2003), and the
/// Levenberg-Marquardt method finds the shifts, starting where the storage moduli of neighbouring temperatures meet.
/// Moduli are not shifted vertically. The reference [K] must be the temperature of a sweep, to 0.01 K; the sweeps may
/// have different frequencies.
/// Throws InputError when the data are bad, two sweeps have the same temperature, or the moduli of neighbouring
/// temperatures do not overlap; NumericalError when there is no convergence.
MasterCurve master_curve(std::vector<FrequencySweep> sweeps, double reference_temperature,
                         const FitOptions& options = {});

}  // namespace breccia
