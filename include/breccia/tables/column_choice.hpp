#pragma once

#include <string>

#include "breccia/io/quantity.hpp"

namespace breccia {

/// A column that stands for a quantity because a user says so, whatever its name means otherwise.
struct ColumnChoice {
  Quantity quantity = Quantity::time;
  std::string name;  ///< of the column in the file, or that and a unit in brackets where the file has none
};

}  // namespace breccia
