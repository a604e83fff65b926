#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "breccia/io/quantity.hpp"
#include "breccia/tables/column_choice.hpp"
#include "breccia/tables/modulus_kind.hpp"

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

/// The meaning of a name where a user has chosen the columns of some quantities: a chosen column has its quantity, and
/// no other column has it.
std::optional<ColumnMeaning> meaning_of(std::string_view name, std::span<const ColumnChoice> choices);

/// Whether a choice means the column of this name.
bool is_choice_of(const ColumnChoice& choice, std::string_view name);

}  // namespace breccia::detail
