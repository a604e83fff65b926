#pragma once

#include <optional>
#include <span>

#include "breccia/viscoelasticity/master_curve.hpp"
#include "breccia/viscoelasticity/temperature_shift.hpp"

namespace breccia {

struct WilliamsLandelFerryFit {
  WilliamsLandelFerry law;
  double c1_error = 0.0;         ///< standard error [-], of factors that are independent
  double c2_error = 0.0;         ///< standard error [K], likewise
  double worst_deviation = 0.0;  ///< of log10 a_T from the law [-]
  double worst_at = 0.0;         ///< its temperature [K]
};

/// The law that meets shift factors best in the least squares of log10 a_T, with a_T = 1 at the reference [K].
/// None when the factors do not bend the way the law does. Throws InputError when temperatures other than the reference
/// are fewer than two, or the factors do not fall with the temperature.
std::optional<WilliamsLandelFerryFit> fit_williams_landel_ferry(std::span<const ShiftFactor> factors,
                                                                double reference_temperature);

}  // namespace breccia
