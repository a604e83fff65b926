#pragma once

#include <string>

#include <fmt/format.h>

namespace breccia::test {

/// A stage of a deck: a cube of eight cells a side, with a side of so many millimetres, in which a sphere of a filler,
/// 0.8 times as wide, is repeated on a simple cubic lattice.
inline std::string lattice_stage(const std::string& name, const std::string& matrix, const std::string& filler,
                                 double side = 1.0) {
  return fmt::format(R"(
[[stages]]
name    = "{}"
matrix  = "{}"
box     = "{:g} mm"
cells   = 8
filler  = {{ material = "{}", sizes = {{ diameter = "{:g} mm" }} }}
packing = {{ method = "regular", lattice = "sc" }}
)",
                     name, matrix, side, filler, 0.8 * side);
}

}  // namespace breccia::test
