#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "breccia/io/modulus_kind.hpp"
#include "breccia/viscoelasticity/creep_compliance.hpp"
#include "breccia/viscoelasticity/reduction.hpp"
#include "breccia/viscoelasticity/temperature_shift_fit.hpp"

#include "fit_data.hpp"

namespace breccia::cli {

/// The function that a curve shows.
enum class CurveKind { relaxation, creep, dynamic };

/// What `breccia fit` has found.
struct FitResult {
  CurveKind measured = CurveKind::relaxation;
  PronySeries modulus;
  CreepCompliance compliance;
  TimeWindow reach;                        ///< of the data; of dynamic ones 1 / omega
  std::optional<FitQuality> quality = {};  ///< none of a Prony series as given
  std::optional<MasterCurve> master_curve = {};
  std::optional<WilliamsLandelFerryFit> law = {};
  ModulusKind kind = ModulusKind::unspecified;  ///< what the columns of the data say, or the user
};

/// J, D of tension or B of pressure.
std::string_view compliance_symbol(ModulusKind kind);

/// A curve at logarithmic times or frequencies over the reach of the data.
struct ConvertedCurve {
  std::vector<double> at;      ///< times [s] or angular frequencies [rad/s]
  std::vector<double> values;  ///< G [Pa], J [1/Pa] or G' [Pa]
  std::vector<double> loss;    ///< G'' [Pa] of a dynamic curve
};
ConvertedCurve converted(const FitResult& result, CurveKind kind, int points_per_decade);

/// Where the files of a fit go.
struct FitDestination {
  std::filesystem::path directory;
  std::filesystem::path source;  ///< the file of the data
  std::string options;           ///< of the command line, by which fits of one file differ
  bool overwrite;                ///< may the fit of other data or with other options be replaced?
};

/// Writes all files of a fit to a directory, which is made, and returns their names; pictures are left out where
/// gnuplot cannot draw. Throws InputError where files would be replaced that are not of an earlier fit of the same
/// data with the same options, and FileError.
std::vector<std::string> write_fit(const FitDestination& destination, const FitData& data, const FitResult& result,
                                   CurveKind kind);

}  // namespace breccia::cli
