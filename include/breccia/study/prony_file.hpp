#pragma once

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "breccia/viscoelasticity/prony_series.hpp"

namespace breccia {

/// What a file of Maxwell elements holds; the equilibrium modulus may be missing.
struct PronyFile {
  std::optional<double> equilibrium;  ///< [Pa]
  std::vector<MaxwellTerm> terms;
};

/// Reads a CSV file with a column relaxation_time_s and one whose name ends in modulus_Pa; an infinite relaxation time
/// marks the equilibrium modulus. Throws InputError with one line for each mistake, and FileError.
PronyFile read_prony_file(const std::filesystem::path& path);

/// Writes such a file, with modulus_Pa as its second column. Throws FileError.
void write_prony_file(const std::filesystem::path& path, const PronySeries& series, std::string_view comment = {});

}  // namespace breccia
