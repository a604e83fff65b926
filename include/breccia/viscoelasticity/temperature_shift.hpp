#pragma once

#include <variant>

#include "breccia/viscoelasticity/shift_table.hpp"

namespace breccia {

/// Williams-Landel-Ferry law of the time-temperature shift factor (J. Am. Chem. Soc. 77, 3701, 1955):
/// log10 a_T = -c1 (T - T_ref) / (c2 + T - T_ref).
struct WilliamsLandelFerry {
  double c1;                     ///< [-], positive
  double c2;                     ///< [K], positive
  double reference_temperature;  ///< [K]

  /// Shift factor a_T at a temperature [K]. Throws InputError at or below T_ref - c2, where the law has no meaning, and
  /// at temperatures so close to it that the factor exceeds 10^100.
  [[nodiscard]] double shift_factor(double temperature) const;
  /// The temperature [K] with a value of log10 a_T; infinite where the law does not reach it.
  [[nodiscard]] double temperature_at(double log10_factor) const;
};

/// The law of Arrhenius, ln a_T = (E_a / R) (1/T - 1/T_ref), for an activation energy [J/mol] and a reference
/// temperature [K]. It is the law of Williams, Landel and Ferry with c2 = T_ref (docs/theory.md, Eq. 28c).
WilliamsLandelFerry arrhenius(double activation_energy, double reference_temperature);

/// A law of the shift factor as a function of the temperature.
using ShiftLaw = std::variant<WilliamsLandelFerry, ShiftTable>;

/// Shift factor a_T at a temperature [K]. Throws InputError where the law has no meaning.
double shift_factor(const ShiftLaw& law, double temperature);

/// A shift law, and the temperature to which a material is shifted by it.
struct TemperatureShift {
  ShiftLaw law;
  double temperature;  ///< temperature of the shifted material [K]
};

}  // namespace breccia
