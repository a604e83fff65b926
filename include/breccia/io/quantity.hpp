#pragma once

namespace breccia {

/// The quantity in a column of a file, with the unit of its values.
enum class Quantity {
  time,                        ///< [s]
  relaxation_time,             ///< [s]
  modulus,                     ///< [Pa]
  compliance,                  ///< [1/Pa]
  storage_modulus,             ///< [Pa]
  loss_modulus,                ///< [Pa]
  absolute_modulus,            ///< |M*|, the absolute value of a complex modulus [Pa]
  phase_angle,                 ///< delta, by which the strain lags behind the stress [rad]
  loss_tangent,                ///< tan(delta) [-]
  angular_frequency,           ///< [rad/s]
  temperature,                 ///< [K]
  diameter,                    ///< [m]
  x,                           ///< [m]
  y,                           ///< [m]
  z,                           ///< [m]
  cumulative_volume_fraction,  ///< volume of the particles up to a diameter over that of all, from 0 to 1 [-]
  weight,                      ///< weight of a site of a tessellation [m^2]
  film_share,                  ///< share of the films around the grain of a site [-]
  filler,              ///< number of the filler of a particle; recognised only beside columns of sizes or corners
  axis_1,              ///< whole first axis of an ellipse [m]
  axis_2,              ///< whole second axis of an ellipse [m]
  angle,               ///< angle from the x axis to the first axis of an ellipse [rad]
  particle,            ///< number of the particle that a corner belongs to
  axis_3,              ///< whole third axis of an ellipsoid [m]
  azimuth,             ///< angle from the x axis to the first axis of an ellipsoid, in the xy plane [rad]
  elevation,           ///< angle of the first axis of an ellipsoid above the xy plane [rad]
  roll,                ///< angle by which an ellipsoid is turned about its first axis [rad]
  shift_factor,        ///< factor a_T of time-temperature superposition [-]
  log10_shift_factor,  ///< decadic logarithm of the shift factor [-]
};

}  // namespace breccia
