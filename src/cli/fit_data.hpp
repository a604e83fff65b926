#pragma once

#include <filesystem>
#include <variant>
#include <vector>

#include "breccia/io/modulus_kind.hpp"
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

/// What a file holds, and of which modulus.
struct FitInput {
  FitData data;
  ModulusKind kind = ModulusKind::unspecified;
};

/// Reads a table; the names of its columns say what it is, and of which modulus where they tell. Where they do not,
/// or tell several, it is the kind given.
/// Throws InputError with what is wrong, as where the file holds another modulus than that given, and FileError.
FitInput read_fit_data(const std::filesystem::path& path, ModulusKind given = ModulusKind::unspecified);

}  // namespace breccia::cli
