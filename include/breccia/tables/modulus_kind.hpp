#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "breccia/words.hpp"

namespace breccia {

/// The kind of modulus, or of compliance, in a column of a file.
enum class ModulusKind {
  unspecified,  ///< a modulus whose kind is not in the name of the column
  shear,        ///< shear modulus G
  young,        ///< Young's modulus E
  bulk,         ///< bulk modulus K
  other         ///< another modulus, such as the P-wave (confined) modulus
};

/// The kinds that a measured modulus of a composite may have, by their keys in decks.
template <>
inline constexpr auto words<ModulusKind> = std::to_array<Word<ModulusKind>>({{"shear", ModulusKind::shear},
                                                                             {"young", ModulusKind::young},
                                                                             {"bulk", ModulusKind::bulk}});

/// The name of a kind: "shear modulus", "Young's modulus", "bulk modulus"; "modulus" for the other kinds.
std::string_view name(ModulusKind kind);

/// The prefix of the names of columns: "shear_", "youngs_", "bulk_"; empty for the other kinds. The moduli of dynamic
/// tests have it, too: "shear_storage_modulus_Pa".
std::string_view column_prefix(ModulusKind kind);

/// The symbol of a kind: G, E or K; G for the other kinds.
std::string_view symbol(ModulusKind kind);

/// The kind meant by a word in the name of a column, such as "shear" or "tensile"; nothing for other words.
std::optional<ModulusKind> kind_of_word(std::string_view word);

/// The end of a message: how to convert the modulus in the file into the wanted one.
std::string conversion_hint(ModulusKind held, ModulusKind wanted);

}  // namespace breccia
