#pragma once

#include <string>

#include "cli/fit_results.hpp"

namespace breccia::cli {

/// Whether the shift factors follow the fitted law: within 0.1 decade, with a c1 that is larger than its error.
bool follows_law(const FitResult& result);

/// The keys of a material of a deck from the result of a fit, a line each: the modulus as the law that was
/// fitted or as the Prony series of `prony.csv` in the given directory (ending with "/" or empty), and the temperature
/// shift by the law that was fitted or, where the factors do not follow it, by their table. The material is at the
/// reference temperature.
std::string material_keys(const FitResult& result, const std::string& directory);

/// The text of `material.toml` for the data of a source: the keys, and a list of the missing ones.
std::string material_file(const FitResult& result, const std::string& source);

}  // namespace breccia::cli
