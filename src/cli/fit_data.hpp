#pragma once

#include <filesystem>
#include <variant>
#include <vector>

#include "breccia/viscoelasticity/master_curve.hpp"
#include "breccia/viscoelasticity/prony_series.hpp"

namespace breccia::cli {

/// A relaxation modulus as measured, by rising time.
struct RelaxationData {
  std::vector<double> times;   ///< [s]
  std::vector<double> moduli;  ///< [Pa]
};

/// A creep compliance as measured, by rising time.
struct CreepData {
  std::vector<double> times;        ///< [s]
  std::vector<double> compliances;  ///< [1/Pa]
};

/// Sweeps of frequency by rising temperature; a single one where the file has no temperatures.
struct DynamicData {
  std::vector<FrequencySweep> sweeps;
};

/// What `breccia fit` can begin with; a Prony series needs no fit.
using FitData = std::variant<RelaxationData, CreepData, DynamicData, PronySeries>;

/// Reads a CSV file; its columns say what it is, and their names end with their units (docs/fitting.md).
/// Throws InputError with one line for each mistake, and FileError.
FitData read_fit_data(const std::filesystem::path& path);

}  // namespace breccia::cli
