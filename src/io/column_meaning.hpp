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

}  // namespace breccia::detail
