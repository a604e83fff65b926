#pragma once

#include <cstddef>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <vector>

#include "breccia/io/modulus_kind.hpp"

namespace breccia {

/// What a column of a file holds; its values in the unit given here.
enum class Quantity {
  time,                        ///< [s]
  relaxation_time,             ///< [s]
  modulus,                     ///< [Pa]
  compliance,                  ///< [1/Pa]
  storage_modulus,             ///< [Pa]
  loss_modulus,                ///< [Pa]
  angular_frequency,           ///< [rad/s]
  temperature,                 ///< [K]
  diameter,                    ///< [m]
  x,                           ///< [m]
  y,                           ///< [m]
  cumulative_volume_fraction,  ///< from 0 to 1
};

/// A column of a file.
struct MeasuredColumn {
  Quantity quantity;
  ModulusKind kind;             ///< of a modulus or compliance
  std::string name;             ///< in the file
  std::vector<double> values;   ///< in the unit of the quantity
  std::vector<double> written;  ///< as they stand in the file
};

/// The columns of a file whose names say what they are. Others are left out, whatever they hold.
class MeasuredTable {
 public:
  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }
  [[nodiscard]] std::size_t rows() const noexcept { return lines_.size(); }
  /// The names of all columns in the order of the file, in quotes, for a message.
  [[nodiscard]] std::string list_of_names() const;
  /// `file:line` of a row, to begin a message about it.
  [[nodiscard]] std::string place(std::size_t row) const;

  [[nodiscard]] bool has(std::initializer_list<Quantity> quantities) const;
  /// The kinds of the moduli and compliances, each once.
  [[nodiscard]] std::vector<ModulusKind> kinds() const;
  /// Throws InputError with a line for each of these quantities that has no column, or one whose unit is not known.
  void require(std::initializer_list<Quantity> quantities) const;
  /// Throws InputError where a column that is left out, for its unit is not known, would be the only one of a quantity.
  void refuse_unknown_units(std::initializer_list<Quantity> quantities) const;
  /// Throws InputError where the rows belong to several curves or series, one below the other, as in tables of results:
  /// of several tasks, stages, loads, boundaries, methods or grids.
  void refuse_several_series() const;
  /// The column of a quantity that has no kind. Throws InputError without one.
  [[nodiscard]] const MeasuredColumn& column(Quantity quantity) const;
  /// The column of a modulus or compliance of some kind, or else one whose kind is not said; any where no kind is
  /// wanted. Throws InputError where there are but columns of other kinds, with what is to be done, and without a
  /// column.
  [[nodiscard]] const MeasuredColumn& column(Quantity quantity, ModulusKind wanted) const;

 private:
  friend class MeasuredTableReader;
  struct UnknownUnit {
    Quantity quantity;
    std::string message;
  };
  /// A line for each column of these quantities that is left out and is the only one of its quantity.
  [[nodiscard]] std::vector<std::string> unknown_units(std::initializer_list<Quantity> quantities) const;

  std::filesystem::path path_;
  std::vector<std::string> names_;
  std::vector<std::size_t> lines_;  ///< of the file, for each row
  std::vector<MeasuredColumn> columns_;
  std::vector<UnknownUnit> unknown_units_;
  bool has_several_series_ = false;
};

}  // namespace breccia
