#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "breccia/study/run.hpp"

namespace breccia {

/// A relaxation modulus that stands beside those of the tests.
struct ReferenceCurve {
  std::string label;
  Curve modulus;
  std::optional<Boundary> boundary;  ///< of the tests that it belongs to; none: of no test, but measured
};

/// Writes `modulus.svg` of a stage, all its tests under shear with what stands beside them and the windows of the time
/// domains, and `bulk_modulus.svg` where its bulk modulus was tested. Writes nothing where gnuplot cannot draw.
void write_plots(const std::filesystem::path& directory, const Study& study, const Stage& stage,
                 const StageResult& result, const std::vector<ReferenceCurve>& references);

}  // namespace breccia
