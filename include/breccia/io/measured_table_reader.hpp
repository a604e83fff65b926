#pragma once

#include <filesystem>

#include "breccia/io/measured_table.hpp"

namespace breccia {

/// Reads a table that an instrument or a spreadsheet has written: separated by commas, semicolons or tabs, with decimal
/// points or, if the separator is not a comma, decimal commas; in UTF-8 or Latin-1. Lines above the first line that
/// names two known columns are skipped. The unit of a column is the end of its name (`time_ms`, `storage_modulus_MPa`,
/// `compliance_1_per_Pa`), in brackets behind its name (`Storage modulus [MPa]`), or in a row of units below the names
/// (docs/decks.md, "Files"). Numbers are finite or `inf`.
/// Throws InputError with all mistakes in the file (FileMistakes), and FileError when it cannot be read.
MeasuredTable read_measured_table(const std::filesystem::path& path);

}  // namespace breccia
