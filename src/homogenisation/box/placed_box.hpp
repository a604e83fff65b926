#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "breccia/homogenisation/box.hpp"

namespace breccia {

/// A box that a packing method has filled.
template <int dim>
struct PlacedBox {
  Box<dim> box = {};
  /// Size deviation of each filler [-]; none where no sizes were drawn.
  std::vector<std::optional<double>> size_deviations = {};
  std::uint64_t events = 0;  ///< number of events of the packing
};

}  // namespace breccia
