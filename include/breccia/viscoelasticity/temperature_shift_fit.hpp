#pragma once

#include <optional>
#include <span>

#include "breccia/viscoelasticity/master_curve.hpp"
#include "breccia/viscoelasticity/temperature_shift.hpp"

namespace breccia {

/// A Williams-Landel-Ferry law fitted to shift factors.
struct WilliamsLandelFerryFit {
  WilliamsLandelFerry law = {};
  double c1_error = 0.0;         ///< standard error of c1, if the factors have independent errors; 0: unknown [-]
  double c2_error = 0.0;         ///< standard error of c2, if the factors have independent errors; 0: unknown [K]
  double worst_deviation = 0.0;  ///< largest deviation of log10 a_T from the law [-]
  double worst_at = 0.0;         ///< temperature of that deviation [K]
};

/// Fits the law to shift factors by least squares of log10 a_T, with a_T = 1 at the reference temperature [K]. Returns
/// nothing when log10 a_T does not level off with rising temperature as the law does. Throws InputError when there are
/// fewer than two different temperatures other than the reference, or the factors do not fall with the temperature;
/// NumericalError when the search does not converge or the data do not determine both constants.
std::optional<WilliamsLandelFerryFit> fit_williams_landel_ferry(std::span<const ShiftFactor> factors,
                                                                double reference_temperature);

/// Whether shift factors follow a law that was fitted to them: within 0.1 decade, and with constants that they
/// determine. Factors measured across the glass transition do not follow a law, nor do two factors, because any law
/// fits two.
bool follow(const WilliamsLandelFerryFit& fit);

/// The law of the shift factors of a master curve: that of Williams, Landel and Ferry where there are four temperatures
/// and the factors follow it, otherwise their table. Returns nothing where the factors do not fall as the temperature
/// rises.
std::optional<ShiftLaw> shift_law_of(const MasterCurve& curve);

}  // namespace breccia
