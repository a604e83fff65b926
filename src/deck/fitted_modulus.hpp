#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "breccia/study/measurement.hpp"
#include "breccia/tables/modulus_kind.hpp"
#include "breccia/viscoelasticity/prony_series.hpp"
#include "breccia/viscoelasticity/reduction.hpp"
#include "breccia/viscoelasticity/temperature_shift.hpp"

namespace breccia {

/// A Prony series fitted to measured data.
struct FittedModulus {
  PronySeries series;  ///< [Pa]
  /// Times of the data [s], for dynamic moduli 1 / omega; nothing for a Prony series.
  std::optional<TimeWindow> measured_times;
  std::optional<ShiftLaw> shift_law = {};     ///< law of a master curve (shift_law_of)
  std::vector<MeasuredModulus> dynamic = {};  ///< the dynamic moduli, by rising (reduced) frequency; empty for others
  double median_error = 0.0;                  ///< median deviation of the series from the data [-]
  bool names_kind = false;                    ///< whether a column of the file is named after the wanted kind
};

/// What the reader of a deck has to know of a modulus that was fitted to the data in a file: that the file does not say
/// of which kind it is, and that the series misses the data by a tenth and more in the median.
std::vector<std::string> remarks_on(const FittedModulus& fitted, const std::filesystem::path& file, ModulusKind kind);

/// The modulus fitted to the measured data in a file (fit_data_in): a relaxation modulus, a creep compliance, dynamic
/// moduli, or dynamic moduli at several temperatures, as a master curve at the reference temperature [K], which must be
/// one of these temperatures to 0.5 K. Throws InputError with all mistakes, FileError, and NumericalError where the fit
/// does not converge.
FittedModulus fitted_modulus(const std::filesystem::path& file, ModulusKind kind,
                             std::optional<double> reference_temperature);

}  // namespace breccia
