#pragma once

#include <filesystem>
#include <vector>

#include "breccia/homogenisation/study_result.hpp"

#include "tables/csv.hpp"

namespace breccia {

/// Writes the errors of all moduli, `errors.csv`; no file without any.
void write_errors(const std::filesystem::path& file, const StudyResult& result);

/// The table of errors, whose numbers are text since they may be missing. Throws FileError and InputError.
CsvTable read_error_table(const std::filesystem::path& file);
/// The error in a row of this table. Throws FileError where the row is not as write_errors() writes it.
ModulusError error_in(const CsvTable& table, std::size_t row);

}  // namespace breccia
