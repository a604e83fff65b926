#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace breccia {

/// A regular lattice of points in the plane: origin + (i * spacing, j * spacing), 0 <= i < nx, 0 <= j < ny.
struct Lattice {
  std::size_t nx = 0;
  std::size_t ny = 0;
  std::array<double, 2> origin{};  ///< of the first point [m]
  double spacing = 0.0;            ///< [m]
};

/// A field on the points of a lattice: a scalar (1), a vector (3) or a symmetric tensor (6: xx, yy, zz, xy, yz, xz).
struct PointField {
  std::string name;
  std::size_t components = 1;
  /// One value after the other: components innermost, then i, then j.
  std::variant<std::vector<double>, std::vector<std::int64_t>> values;
};

/// Writes fields as a VTKHDF file (version 1.0, ImageData), which ParaView 5.11 and later open. Throws FileError, and
/// InputError when a field does not fit the lattice.
void write_vtkhdf(const std::filesystem::path& path, const Lattice& lattice, const std::vector<PointField>& fields);

}  // namespace breccia
