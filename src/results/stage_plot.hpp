#pragma once

#include <filesystem>

#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// Writes `modulus.svg` of the last stage of a result to its directory: all its tests under shear, the matrix, measured
/// moduli, and the windows of the time domains; and `bulk_modulus.svg` where its bulk modulus was tested. Throws
/// FileError where a file cannot be written.
void write_plots(const std::filesystem::path& directory, const Study& study, const Stage& stage,
                 const StudyResult& result);

}  // namespace breccia
