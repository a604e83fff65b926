#pragma once

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "breccia/tables/modulus_kind.hpp"
#include "breccia/viscoelasticity/prony_series.hpp"

namespace breccia {

/// The content of a file of Maxwell elements; the equilibrium modulus may be missing.
struct PronyFile {
  std::optional<double> equilibrium;  ///< [Pa]
  std::vector<MaxwellTerm> terms;
};

/// Reads a table (read_measured_table) of relaxation times and moduli of the given kind; an infinite relaxation time
/// marks the equilibrium modulus. Throws InputError with all mistakes in the file, for example if the moduli are of
/// another kind or the file has the series of several tests, and FileError when it cannot be read.
PronyFile read_prony_file(const std::filesystem::path& path, ModulusKind kind = ModulusKind::unspecified);

/// Writes a file that read_prony_file() reads. The second column is named `modulus_Pa`, preceded by the kind if that is
/// specified. Throws FileError.
void write_prony_file(const std::filesystem::path& path, const PronySeries& series,
                      ModulusKind kind = ModulusKind::unspecified, std::string_view comment = {});

}  // namespace breccia
