#pragma once

#include <variant>
#include <vector>

#include "breccia/tables/measured_table.hpp"
#include "breccia/tables/modulus_kind.hpp"
#include "breccia/viscoelasticity/master_curve.hpp"
#include "breccia/viscoelasticity/prony_series.hpp"

namespace breccia {

/// A measured relaxation modulus, by rising time.
struct RelaxationData {
  std::vector<double> times;   ///< [s]
  std::vector<double> moduli;  ///< [Pa]
};

/// A measured creep compliance, by rising time.
struct CreepData {
  std::vector<double> times;        ///< [s]
  std::vector<double> compliances;  ///< [1/Pa]
};

/// Frequency sweeps by rising temperature; a single one if the file has no temperatures.
struct DynamicData {
  std::vector<FrequencySweep> sweeps;
  /// The sweeps were interpolated between the temperatures of a ramp. There may be more of them than measured points,
  /// so that the standard errors of a fit to them are too small.
  bool is_of_ramp = false;
};

/// The data that can be fitted; a Prony series needs no fit.
using FitData = std::variant<RelaxationData, CreepData, DynamicData, PronySeries>;

/// The data in a file, and their kind of modulus.
struct FitInput {
  FitData data;
  ModulusKind kind = ModulusKind::unspecified;
};

/// The data in a table. The names of its columns determine the type of the data and, if possible, the kind of modulus.
/// If they give no kind or several, `given` is used. Throws InputError with all mistakes, for example if the table has
/// another modulus than `given`.
FitInput measured_data_in(const MeasuredTable& table, ModulusKind given = ModulusKind::unspecified);

/// The same of a table that has enough rows for a fit. Throws InputError for fewer than three.
FitInput fit_data_in(const MeasuredTable& table, ModulusKind given = ModulusKind::unspecified);

}  // namespace breccia
