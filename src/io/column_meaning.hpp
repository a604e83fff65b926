#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "breccia/io/measured_table.hpp"

namespace breccia::detail {

/// The meaning of the name of a column. The unit is not checked against the quantity.
struct ColumnMeaning {
  Quantity quantity;
  ModulusKind kind;
  bool counts_cycles;  ///< true for a frequency in cycles (Hz) instead of an angular frequency
  std::string unit;    ///< unit in the name; empty if there is none
};

/// The meaning of a name such as `shear_modulus_MPa`, `Storage modulus G' [MPa]`, `Temp (°C)` or `time / s`; nothing
/// for an unknown name.
std::optional<ColumnMeaning> meaning_of(std::string_view name);

}  // namespace breccia::detail
