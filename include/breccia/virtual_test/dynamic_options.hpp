#pragma once

#include <optional>
#include <vector>

#include "breccia/dynamics/formulation.hpp"

namespace breccia {

/// Settings of the dynamic method.
struct DynamicOptions {
  Formulation formulation = Formulation::total_lagrangian;
  Start start = Start::boundary;
  double courant = 0.9;        ///< time step over the stable limit of the discretisation [-]
  double ramp_transits = 2.0;  ///< duration of the strain ramp in transits of the shear wave [-]
  /// Duration of a traction ramp in transits [-]; longer, because a free boundary rings longer.
  double creep_ramp_transits = 5.0;
  std::optional<double> ramp_time = {};  ///< duration of the ramp at mass scaling factor 1 [s]; overrides ramp_transits
  /// Mass scaling factors, rising [-]; empty: chosen from the requested times.
  std::vector<double> mass_scaling_factors = {};
  double overlap = 1.5;               ///< ratio of times over which two neighbouring runs overlap [-]
  double reduction_tolerance = 1e-3;  ///< tolerated relative error of G(t) by neglected Prony terms [-]
};

}  // namespace breccia
