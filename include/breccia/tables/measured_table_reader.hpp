#pragma once

#include <filesystem>
#include <span>

#include "breccia/tables/column_choice.hpp"
#include "breccia/tables/measured_table.hpp"

namespace breccia {

/// Reads a table that an instrument or a spreadsheet has written: separated by commas, semicolons or tabs, with decimal
/// points or, if the separator is not a comma, decimal commas; in UTF-8, Latin-1 or UTF-16. Lines above the first line
/// that names two known columns are skipped; if there is no such line, a comment line (#) may hold the names. The unit
/// of a column is the end of its name (`time_ms`, `storage_modulus_MPa`, `compliance_1_per_Pa`), in brackets behind its
/// name (`Storage modulus [MPa]`), or in a row of units below the names (docs/decks.md, "Files"). Numbers are finite or
/// `inf`. A quantity in `choices` is read from the chosen column alone. Throws InputError with all mistakes in the file
/// (FileMistakes), also where the file lacks a chosen column, and FileError when the file cannot be read.
MeasuredTable read_measured_table(const std::filesystem::path& path, std::span<const ColumnChoice> choices = {});

}  // namespace breccia
