#pragma once

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
};

/// A shift law, and the temperature to which a material is shifted by it.
struct TemperatureShift {
  WilliamsLandelFerry law;
  double temperature;  ///< temperature of the shifted material [K]
};

}  // namespace breccia
