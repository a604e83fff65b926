#pragma once

#include <string>

#include "cli/fit_results.hpp"

namespace breccia::cli {

/// Whether the shift factors follow the law that was fitted: within 0.1 decade, with a c1 larger than its error.
bool follows_law(const FitResult& result);

/// The keys of a material of a deck that a fit has found, a line each: the modulus as the Prony series of `prony.csv`
/// in the given directory (ending with "/" or empty), and the temperature shift by the law that was fitted or, where
/// the factors do not follow it, by their table. The material is at the reference temperature.
std::string material_keys(const FitResult& result, const std::string& directory);

/// The text of `material.toml` for the data of a source: the keys, and which are missing.
std::string material_file(const FitResult& result, const std::string& source);

}  // namespace breccia::cli
