#pragma once

#include <string>

#include "breccia/io/quantity.hpp"

namespace breccia {

/// A user's choice of the column of a quantity, which overrides the meaning of its name.
struct ColumnChoice {
  Quantity quantity = Quantity::time;
  std::string name;  ///< name of the column in the file, followed by a unit in brackets where the file has none
};

}  // namespace breccia
