#pragma once

#include <optional>
#include <vector>

#include "breccia/discretisation/volumetric.hpp"
#include "breccia/dynamics/dynamic_problem.hpp"

namespace breccia {

/// Settings of the dynamic method.
struct DynamicOptions {
  Formulation formulation = Formulation::total_lagrangian;
  Start start = Start::boundary;
  Volumetric volumetric = Volumetric::averaged;
  double courant = 0.9;                      ///< time step over the stable limit of the discretisation [-]
  double ramp_transits = 2.0;                ///< duration of the strain ramp in transits of the shear wave [-]
  double creep_ramp_transits = 5.0;          ///< the same of the traction's ramp, since a free boundary rings longer
  std::optional<double> ramp_time = {};      ///< the same as a time at density factor 1 [s]; overrides ramp_transits
  std::vector<double> density_factors = {};  ///< rising [-]; empty: chosen from the requested times
  double overlap = 1.5;                      ///< ratio of times for which a run goes on beside the next one [-]
  double reduction_tolerance = 1e-3;         ///< relative error of G(t) that leaving out Prony terms may cause [-]
};

}  // namespace breccia
