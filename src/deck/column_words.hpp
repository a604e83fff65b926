#pragma once

#include <string>
#include <vector>

#include "breccia/tables/column_choice.hpp"

namespace breccia {

/// A column of measured data that a user chooses: a word for the quantity (time, frequency, temperature, storage, loss,
/// absolute, phase, tangent, modulus or compliance), and the name of the column.
struct NamedColumn {
  std::string quantity;
  std::string name;
};

/// The choices of columns by these words. Throws InputError with a line for each word that is unknown or given twice;
/// the line begins with `argument`, the name of the option or argument that gives the columns.
std::vector<ColumnChoice> column_choices(const std::vector<NamedColumn>& columns, const std::string& argument);

}  // namespace breccia
