#pragma once

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "breccia/io/modulus_kind.hpp"
#include "breccia/viscoelasticity/prony_series.hpp"

namespace breccia {

/// What a file of Maxwell elements holds; the equilibrium modulus may be missing.
struct PronyFile {
  std::optional<double> equilibrium;  ///< [Pa]
  std::vector<MaxwellTerm> terms;
};

/// Reads a table (read_measured_table) of relaxation times and moduli of some kind; an infinite relaxation time marks
/// the equilibrium modulus. Throws InputError with what is wrong, as where the moduli are of another kind, and
/// FileError.
PronyFile read_prony_file(const std::filesystem::path& path, ModulusKind kind = ModulusKind::unspecified);

/// Writes such a file; the second column is called `modulus_Pa`, with the kind before it where that is known. Throws
/// FileError.
void write_prony_file(const std::filesystem::path& path, const PronySeries& series,
                      ModulusKind kind = ModulusKind::unspecified, std::string_view comment = {});

}  // namespace breccia
