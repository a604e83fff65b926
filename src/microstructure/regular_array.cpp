#include "breccia/microstructure/regular_array.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia {

Microstructure regular_array(double side, int columns, int rows, double diameter, Walls walls) {
  if (!(side > 0.0) || !std::isfinite(side)) {
    throw InputError(fmt::format("regular array: the side of the box must be positive, got {} m", side));
  }
  if (columns < 1 || rows < 1) {
    throw InputError(fmt::format("regular array: needs at least one column and one row, got {} x {}", columns, rows));
  }
  const double width = side / columns;
  const double height = side / rows;
  if (!(diameter > 0.0) || !(diameter < std::min(width, height))) {
    throw InputError(
        fmt::format("regular array: {} x {} discs in a box of side {} m must have a positive diameter below {} m, or "
                    "they touch; got {} m",
                    columns, rows, side, std::min(width, height), diameter));
  }
  Microstructure microstructure{side, walls, {}};
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      microstructure.discs.push_back({{(column + 0.5) * width, (row + 0.5) * height}, diameter});
    }
  }
  return microstructure;
}

}  // namespace breccia
