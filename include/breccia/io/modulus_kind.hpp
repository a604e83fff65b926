#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace breccia {

/// Which modulus, or its compliance, a column of a file holds.
enum class ModulusKind {
  unspecified,  ///< the column says only that it is a modulus
  shear,        ///< G, of shear
  young,        ///< E, of tension
  bulk,         ///< K, of equal pressure from all sides
  other         ///< one from which none of these follows, such as that of a confined column
};

/// "shear modulus", "Young's modulus", "bulk modulus", or else "modulus".
std::string_view name(ModulusKind kind);

/// With what names of columns begin: "shear_", "youngs_", "bulk_", or else nothing. Moduli of dynamic tests carry it
/// too: "shear_storage_modulus_Pa".
std::string_view column_prefix(ModulusKind kind);

/// G, E or K; also G where the kind is not known.
std::string_view symbol(ModulusKind kind);

/// The kind that a word in the name of a column tells, such as "shear" or "tensile".
std::optional<ModulusKind> kind_of_word(std::string_view word);

/// How to come from the modulus that a file holds to the one that is wanted: the end of a message.
std::string conversion_hint(ModulusKind held, ModulusKind wanted);

}  // namespace breccia
