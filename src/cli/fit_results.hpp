#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "breccia/tables/modulus_kind.hpp"
#include "breccia/viscoelasticity/creep_compliance.hpp"
#include "breccia/viscoelasticity/law_fit.hpp"
#include "breccia/viscoelasticity/reduction.hpp"
#include "breccia/viscoelasticity/temperature_shift_fit.hpp"

#include "deck/fit_data.hpp"

namespace breccia::cli {

/// The viscoelastic function of a curve.
enum class CurveKind { relaxation, creep, dynamic };

/// "relaxation", "creep" or "dynamic".
std::string word_for(CurveKind kind);

/// The result of `breccia fit`.
struct FitResult {
  CurveKind measured = CurveKind::relaxation;
  PronySeries modulus;
  CreepCompliance compliance;
  TimeWindow reach;                        ///< range of the data [s]; for dynamic data the range of 1 / omega
  std::optional<FitQuality> quality = {};  ///< quality of the fit; nothing for a given Prony series
  std::optional<MasterCurve> master_curve = {};
  std::optional<WilliamsLandelFerryFit> shift_law = {};
  std::optional<LawFit> law = {};                   ///< in place of the spectrum, where a law was asked for
  std::optional<FitQuality> spectrum_quality = {};  ///< of the fit of a spectrum, beside that of a law
  ModulusKind kind = ModulusKind::unspecified;      ///< kind of modulus, from the names of the columns or from the user
};

/// The symbol of the compliance of a kind: J in shear, D in tension, B under pressure.
std::string_view compliance_symbol(ModulusKind kind);

/// A curve at logarithmic times or frequencies over the range of the data.
struct ConvertedCurve {
  std::vector<double> at;      ///< times [s] or angular frequencies [rad/s]
  std::vector<double> values;  ///< G [Pa], J [1/Pa] or G' [Pa]
  std::vector<double> loss;    ///< G'' [Pa], for a dynamic curve only
};
ConvertedCurve converted(const FitResult& result, CurveKind kind, int points_per_decade);

/// The directory for the files of a fit, and the origin of the fit.
struct FitDestination {
  std::filesystem::path directory;
  std::filesystem::path source;  ///< the file of the data
  std::string options;           ///< command-line options that affect the fit
  bool overwrite;                ///< whether a fit of other data or with other options may be replaced
};

/// Writes all files of a fit to a directory, which is created if it is missing, and returns their names. Throws
/// InputError if files would be replaced that are not of an earlier fit of the same data with the same options (unless
/// `overwrite`), and FileError.
std::vector<std::string> write_fit(const FitDestination& destination, const FitData& data, const FitResult& result,
                                   CurveKind kind);

}  // namespace breccia::cli
