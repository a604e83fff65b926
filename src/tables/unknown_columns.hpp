#pragma once

#include "breccia/error.hpp"

namespace breccia {

/// Error: the names of a table's columns do not reveal its quantities. A choice of columns (ColumnChoice) helps.
class UnknownColumns : public InputError {
 public:
  using InputError::InputError;
};

}  // namespace breccia
