#pragma once

#include <cstddef>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <vector>

#include "breccia/io/quantity.hpp"
#include "breccia/tables/modulus_kind.hpp"

namespace breccia {

/// A column of a file.
struct MeasuredColumn {
  Quantity quantity;
  ModulusKind kind;             ///< kind of a modulus or compliance
  std::string name;             ///< name of the column in the file
  std::string unit;             ///< unit of the numbers in the file, as written there
  std::vector<double> values;   ///< values in the unit of the quantity
  std::vector<double> written;  ///< the numbers in the file
};

/// The way in which a table was read.
struct TableReading {
  std::string encoding;  ///< of a text: "UTF-8", "Latin-1" or "UTF-16"; empty for a workbook
  std::string sheet;     ///< of a workbook: the name of the sheet; empty for a text
  char separator = ',';  ///< separator of the columns; a blank stands for two blanks and more
  bool has_decimal_commas = false;
  std::size_t line_of_names = 0;  ///< line (row of a sheet) of the names of the columns, from 1
  bool has_row_of_units = false;  ///< whether a row of units follows the names
  std::size_t tables = 1;         ///< number of tables of the same columns, one below the other
};

/// A table of measured data: the columns of a file that are recognised by their names. Other columns are ignored.
class MeasuredTable {
 public:
  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }
  [[nodiscard]] std::size_t rows() const noexcept { return lines_.size(); }
  [[nodiscard]] const TableReading& reading() const noexcept { return reading_; }
  /// The columns that are recognised, in the order of the file.
  [[nodiscard]] const std::vector<MeasuredColumn>& columns() const noexcept { return columns_; }
  /// The names of all columns in the order of the file.
  [[nodiscard]] const std::vector<std::string>& names() const noexcept { return names_; }
  /// The names of all columns in the order of the file, in quotes, for a message.
  [[nodiscard]] std::string list_of_names() const;
  /// Location of a row, `file:line` or `file:sheet:row`, for messages about it.
  [[nodiscard]] std::string location(std::size_t row) const;

  /// Whether there is a column for each of these quantities.
  [[nodiscard]] bool has(std::initializer_list<Quantity> quantities) const;
  /// The kinds of all moduli and compliances, without repetition.
  [[nodiscard]] std::vector<ModulusKind> kinds() const;
  /// Throws InputError with a line for each of these quantities that has no column, or only one with an unknown unit.
  void require(std::initializer_list<Quantity> quantities) const;
  /// Throws InputError if the only column of one of these quantities was ignored because its unit is unknown.
  void refuse_unknown_units(std::initializer_list<Quantity> quantities) const;
  /// Throws InputError if the rows belong to several curves or series, one below the other, as in Breccia's tables of
  /// results: of several tasks, stages, loads, boundaries, methods or grids.
  void refuse_several_series() const;
  /// The column of a quantity other than a modulus or compliance. Throws InputError if there is none.
  [[nodiscard]] const MeasuredColumn& column(Quantity quantity) const;
  /// The column of a modulus or compliance of the wanted kind, or else of unspecified kind; any column if the wanted
  /// kind is unspecified. Throws InputError if there is no column, or only columns of other kinds, with the conversion.
  [[nodiscard]] const MeasuredColumn& column(Quantity quantity, ModulusKind wanted) const;

 private:
  friend class MeasuredTableReader;
  struct UnknownUnit {
    Quantity quantity;
    std::string message;
  };
  /// Location of a line, from 1.
  [[nodiscard]] std::string place_of_line(std::size_t line) const;
  /// A message for each ignored column that is the only column of one of these quantities.
  [[nodiscard]] std::vector<std::string> unknown_units(std::initializer_list<Quantity> quantities) const;

  std::filesystem::path path_;
  TableReading reading_;
  std::vector<std::string> names_;
  std::vector<std::size_t> lines_;  ///< line number of each row in the file
  std::vector<MeasuredColumn> columns_;
  std::vector<UnknownUnit> unknown_units_;
  bool has_several_series_ = false;
};

}  // namespace breccia
