#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "breccia/study/sweep.hpp"

namespace breccia {

/// The values of a swept key as numbers in one unit.
struct SweptQuantity {
  std::string unit;             ///< unit of the first task's value
  std::vector<double> numbers;  ///< one for each task
};

/// The values of a key of a sweep as quantities; nothing unless all of them are quantities of one dimension.
std::optional<SweptQuantity> swept_quantity(const Sweep& sweep, std::size_t key);

}  // namespace breccia
