#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "breccia/io/measured_table.hpp"

namespace breccia::detail {

/// What the name of a column says. Whether the unit is one of the quantity is another question.
struct ColumnMeaning {
  Quantity quantity;
  ModulusKind kind;
  bool counts_cycles;  ///< a frequency, in Hz, in the place of an angular one
  std::string unit;    ///< as it stands there; empty without one
};

/// The meaning of a name such as `shear_modulus_MPa`, `Storage modulus G' [MPa]`, `Temp (°C)` or `time / s`; nothing
/// for a name that is not known.
std::optional<ColumnMeaning> meaning_of(std::string_view name);

/// SI value = value * factor / divisor + offset. Of factor and divisor one is 1: so that 7 in um becomes the same bits
/// as 7e-6 in m.
struct Conversion {
  double factor = 1.0;
  double divisor = 1.0;
  double offset = 0.0;

  [[nodiscard]] double operator()(double value) const;
};

/// How values of a column become those in the unit of its quantity. Throws InputError where the unit is not known.
Conversion conversion_of(const ColumnMeaning& meaning);

}  // namespace breccia::detail
