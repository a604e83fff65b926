#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// Writes `modulus.svg` of the last stage of a result to its directory: all its tests under shear, the matrix and what
/// was measured, and the windows of the time domains; and `bulk_modulus.svg` where its bulk modulus was tested. Writes
/// nothing where there is no gnuplot. Returns a line for each plot that gnuplot could not draw, which is left out.
/// Throws FileError where a file cannot be written.
std::vector<std::string> write_plots(const std::filesystem::path& directory, const Study& study, const Stage& stage,
                                     const StudyResult& result);

}  // namespace breccia
