#pragma once

#include <filesystem>

#include "breccia/io/measured_table.hpp"

namespace breccia {

/// Reads a table as instruments and spreadsheets write it: separated by commas, semicolons or tabs, with decimal points
/// or, where commas do not separate, decimal commas; as UTF-8 or Latin-1. Lines before the first that names two known
/// columns are skipped. The unit of a column ends its name (`time_ms`, `storage_modulus_MPa`,
/// `compliance_1_per_Pa`), stands there in brackets (`Storage modulus [MPa]`), or in a row of units below the names
/// (docs/decks.md, "Files"). Numbers are finite or `inf`.
/// Throws InputError with what is wrong (FileMistakes), and FileError.
MeasuredTable read_measured_table(const std::filesystem::path& path);

}  // namespace breccia
