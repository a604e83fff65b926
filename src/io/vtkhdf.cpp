#include "breccia/io/vtkhdf.hpp"

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/io/hdf5.hpp"

namespace breccia {

namespace {

using Integers = std::vector<std::int64_t>;

void check(const std::filesystem::path& path, const Lattice& lattice, const LatticeField& field) {
  const auto size = std::visit([](const auto& values) { return values.size(); }, field.values);
  const auto expected = lattice.nx * lattice.ny * field.components;
  if (field.components != 1 && field.components != 3 && field.components != 6) {
    throw InputError(fmt::format("{}: field {}: expected 1, 3 or 6 components, got {}", path.string(), field.name,
                                 field.components));
  }
  if (size != expected) {
    throw InputError(
        fmt::format("{}: field {}: expected {} values, got {}", path.string(), field.name, expected, size));
  }
}

/// Coordinates of the corners of all squares, row by row.
std::vector<double> corners(const Lattice& lattice) {
  std::vector<double> points;
  for (std::size_t row = 0; row <= lattice.ny; ++row) {
    for (std::size_t column = 0; column <= lattice.nx; ++column) {
      points.insert(points.end(), {lattice.origin[0] + static_cast<double>(column) * lattice.spacing,
                                   lattice.origin[1] + static_cast<double>(row) * lattice.spacing, 0.0});
    }
  }
  return points;
}

/// Indices of the corners of each square, anticlockwise.
Integers connectivity(const Lattice& lattice) {
  Integers indices;
  const auto row_length = static_cast<std::int64_t>(lattice.nx) + 1;
  for (std::int64_t row = 0; row < static_cast<std::int64_t>(lattice.ny); ++row) {
    for (std::int64_t column = 0; column + 1 < row_length; ++column) {
      const auto first = row * row_length + column;
      indices.insert(indices.end(), {first, first + 1, first + row_length + 1, first + row_length});
    }
  }
  return indices;
}

void write_squares(Hdf5Writer& file, const Lattice& lattice) {
  constexpr std::size_t corners_of_square = 4;
  constexpr std::uint8_t quadrilateral = 9;  // VTK_QUAD
  const auto squares = lattice.nx * lattice.ny;
  const auto points = corners(lattice);
  const auto indices = connectivity(lattice);
  Integers offsets(squares + 1);
  for (std::size_t i = 0; i < offsets.size(); ++i) offsets[i] = static_cast<std::int64_t>(corners_of_square * i);
  const std::vector<std::uint8_t> types(squares, quadrilateral);
  const auto write_count = [&](const std::string& name, std::size_t count) {
    file.write("/VTKHDF/" + name, std::array{static_cast<std::int64_t>(count)});
  };
  write_count("NumberOfPoints", points.size() / 3);
  write_count("NumberOfCells", squares);
  write_count("NumberOfConnectivityIds", indices.size());
  file.write_compressed("/VTKHDF/Points", std::span<const double>(points), {points.size() / 3, 3});
  file.write_compressed("/VTKHDF/Connectivity", std::span<const std::int64_t>(indices), {indices.size()});
  file.write_compressed("/VTKHDF/Offsets", std::span<const std::int64_t>(offsets), {offsets.size()});
  file.write_compressed("/VTKHDF/Types", std::span<const std::uint8_t>(types), {types.size()});
}

}  // namespace

void write_vtkhdf(const std::filesystem::path& path, const Lattice& lattice, const std::vector<LatticeField>& fields,
                  const std::vector<FieldNumber>& numbers) {
  for (const auto& field : fields) check(path, lattice, field);
  Hdf5Writer file(path);
  file.create_group("/VTKHDF");
  file.write_attribute("/VTKHDF", "Version", Integers{1, 0});
  file.write_attribute("/VTKHDF", "Type", "UnstructuredGrid");
  for (const auto& [name, value] : numbers) file.write_attribute("/VTKHDF", name, value);
  write_squares(file, lattice);
  for (const auto& field : fields) {
    Hdf5Shape shape{lattice.nx * lattice.ny};
    if (field.components > 1) shape.push_back(field.components);
    std::visit(
        [&](const auto& values) {
          using Value = typename std::decay_t<decltype(values)>::value_type;
          file.write_compressed("/VTKHDF/CellData/" + field.name, std::span<const Value>(values), shape);
        },
        field.values);
  }
  file.commit();
}

}  // namespace breccia
