#pragma once

#include <filesystem>

#include "breccia/homogenisation/study_result.hpp"

namespace breccia {

/// Writes the storage and loss moduli of the series of prony.csv, at the angular frequencies 1/t of the times of the
/// curves; no file where there is no series. Throws FileError.
void write_dynamic_curves(const std::filesystem::path& file, const StudyResult& result);

}  // namespace breccia
