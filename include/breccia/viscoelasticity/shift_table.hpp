#pragma once

#include <vector>

namespace breccia {

/// Shift factors that were measured at some temperatures; between them log10 a_T is linear in the temperature, beyond
/// them it is not known (docs/theory.md, Eq. 28d).
class ShiftTable {
 public:
  /// The largest magnitude of log10 a_T: factors above 10^100 or below 10^-100 are refused as mistakes.
  static constexpr double most_decades = 100.0;

  /// Takes log10 a_T by temperature [K], relative to any temperature; a_T becomes one at the reference temperature [K].
  /// Throws InputError: fewer than two temperatures, temperatures that do not rise or are not above zero, factors that
  /// do not fall or are out of range, or a reference temperature outside the table.
  ShiftTable(std::vector<double> temperatures, std::vector<double> log10_factors, double reference_temperature);

  [[nodiscard]] const std::vector<double>& temperatures() const noexcept { return temperatures_; }
  /// The values of log10 a_T at temperatures(), relative to the reference temperature.
  [[nodiscard]] const std::vector<double>& log10_factors() const noexcept { return log10_factors_; }
  [[nodiscard]] double reference_temperature() const noexcept { return reference_temperature_; }

  /// Shift factor a_T at a temperature [K]. Throws InputError outside the table.
  [[nodiscard]] double shift_factor(double temperature) const;
  /// The temperature [K] with a value of log10 a_T; the first or last of the table where all its factors are smaller or
  /// larger.
  [[nodiscard]] double temperature_at(double log10_factor) const;

 private:
  [[nodiscard]] double log10_factor(double temperature) const;

  std::vector<double> temperatures_;
  std::vector<double> log10_factors_;
  double reference_temperature_;
};

}  // namespace breccia
