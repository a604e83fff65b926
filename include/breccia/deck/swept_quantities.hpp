#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "breccia/deck/sweep.hpp"

namespace breccia {

/// The values of a swept key that are quantities, as numbers in one unit.
struct SweptQuantity {
  std::string unit;             ///< that of the first task's value
  std::vector<double> numbers;  ///< of each task
};

/// The quantities of a key of a sweep; nothing where not all of its values are quantities of one dimension.
std::optional<SweptQuantity> swept_quantity(const Sweep& sweep, std::size_t key);

}  // namespace breccia
