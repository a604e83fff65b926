#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "breccia/homogenisation/box.hpp"

namespace breccia {

/// A box as a packing method has filled it.
template <int dim>
struct PlacedBox {
  Box<dim> box = {};
  std::vector<std::optional<double>> size_deviations = {};  ///< of each filler [-]; none where no sizes were drawn
  std::uint64_t events = 0;                                 ///< of the packing
};

}  // namespace breccia
