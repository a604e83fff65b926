#pragma once

#include <map>
#include <string>
#include <vector>

#include "breccia/io/csv.hpp"

namespace breccia::cli {

/// What a column of measured data can hold; its values in the unit given here.
enum class Quantity {
  time,               ///< [s]
  relaxation_time,    ///< [s]
  modulus,            ///< [Pa]
  compliance,         ///< [1/Pa]
  storage_modulus,    ///< [Pa]
  loss_modulus,       ///< [Pa]
  angular_frequency,  ///< [rad/s]
  temperature         ///< [K]
};

/// A column of a file: its name there and its values in the unit of its quantity.
struct MeasuredColumn {
  std::string name;
  std::vector<double> values;
};

/// The columns of a table whose names say what they are: `storage_modulus_MPa`, `frequency_Hz`, `shear_modulus_Pa`,
/// `compliance_1_per_Pa`. Other columns are left out.
/// Throws InputError with one line for each unknown unit and each second column of a quantity.
std::map<Quantity, MeasuredColumn> measured_columns(const CsvTable& table);

}  // namespace breccia::cli
