#include "breccia/io/vtkhdf.hpp"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/io/hdf5.hpp"

namespace breccia {

namespace {

using Integers = std::vector<std::int64_t>;

void check(const std::filesystem::path& path, std::size_t count, const MeshField& field) {
  const auto size = std::visit([](const auto& values) { return values.size(); }, field.values);
  const auto expected = count * field.components;
  if (field.components != 1 && field.components != 3 && field.components != 6) {
    throw InputError(fmt::format("{}: field {}: expected 1, 3 or 6 components, got {}", path.string(), field.name,
                                 field.components));
  }
  if (size != expected) {
    throw InputError(
        fmt::format("{}: field {}: expected {} values, got {}", path.string(), field.name, expected, size));
  }
}

void check(const std::filesystem::path& path, const PolygonMesh& mesh) {
  constexpr std::int64_t fewest = 3;
  const auto sum = std::accumulate(mesh.corner_counts.begin(), mesh.corner_counts.end(), std::int64_t{0});
  const auto points = static_cast<std::int64_t>(mesh.points.size());
  const bool has_all_points =
      std::ranges::all_of(mesh.corners, [points](std::int64_t point) { return point >= 0 && point < points; });
  const bool has_polygons =
      std::ranges::all_of(mesh.corner_counts, [](std::int64_t corners) { return corners >= fewest; });
  if (sum == static_cast<std::int64_t>(mesh.corners.size()) && has_all_points && has_polygons) return;
  throw InputError(
      fmt::format("{}: the corners of the polygons do not fit their numbers or the points", path.string()));
}

PolygonMesh squares_of(const PlaneLattice& lattice) {
  PolygonMesh mesh;
  for (std::size_t row = 0; row <= lattice.ny; ++row) {
    for (std::size_t column = 0; column <= lattice.nx; ++column) {
      mesh.points.push_back({lattice.origin[0] + static_cast<double>(column) * lattice.spacing,
                             lattice.origin[1] + static_cast<double>(row) * lattice.spacing});
    }
  }
  const auto row_length = static_cast<std::int64_t>(lattice.nx) + 1;
  for (std::int64_t row = 0; row < static_cast<std::int64_t>(lattice.ny); ++row) {
    for (std::int64_t column = 0; column + 1 < row_length; ++column) {
      const auto first = row * row_length + column;
      mesh.corners.insert(mesh.corners.end(), {first, first + 1, first + row_length + 1, first + row_length});
    }
  }
  constexpr std::int64_t corners_of_square = 4;
  mesh.corner_counts.assign(lattice.nx * lattice.ny, corners_of_square);
  return mesh;
}

/// VTK_TRIANGLE, VTK_QUAD or VTK_POLYGON.
std::uint8_t vtk_type(std::int64_t corners) {
  constexpr std::uint8_t triangle = 5, polygon = 7, quadrilateral = 9;
  if (corners == 3) return triangle;
  return corners == 4 ? quadrilateral : polygon;
}

/// Cells of any kind in space, as VTK lists them.
struct CellMesh {
  std::vector<double> points;       ///< three coordinates each [m]
  Integers corners;                 ///< of the cells, one cell after the other
  Integers offsets = {0};           ///< of the corners of each cell, and the number of all
  std::vector<std::uint8_t> types;  ///< of the cells
};

CellMesh cells_of(const PolygonMesh& polygons) {
  CellMesh mesh;
  for (const auto& [x, y] : polygons.points) mesh.points.insert(mesh.points.end(), {x, y, 0.0});
  mesh.corners = polygons.corners;
  for (const auto corners : polygons.corner_counts) {
    mesh.offsets.push_back(mesh.offsets.back() + corners);
    mesh.types.push_back(vtk_type(corners));
  }
  return mesh;
}

/// Calls action(x, y, z) for all places in a lattice, x fastest.
template <class Action>
void for_each_place(const std::array<std::size_t, 3>& along, const Action& action) {
  for (std::size_t z = 0; z < along[2]; ++z) {
    for (std::size_t y = 0; y < along[1]; ++y) {
      for (std::size_t x = 0; x < along[0]; ++x) action(x, y, z);
    }
  }
}

CellMesh cells_of(const CubeLattice& lattice) {
  CellMesh mesh;
  const auto& [nx, ny, nz] = lattice.cubes;
  for_each_place({nx + 1, ny + 1, nz + 1}, [&](std::size_t x, std::size_t y, std::size_t z) {
    const std::array place = {x, y, z};
    for (std::size_t axis = 0; axis < place.size(); ++axis) {
      mesh.points.push_back(lattice.origin[axis] + static_cast<double>(place[axis]) * lattice.spacing);
    }
  });
  const auto row = static_cast<std::int64_t>(nx) + 1, layer = row * (static_cast<std::int64_t>(ny) + 1);
  constexpr std::int64_t corners_of_cube = 8;
  constexpr std::uint8_t hexahedron = 12;
  for_each_place(lattice.cubes, [&](std::size_t x, std::size_t y, std::size_t z) {
    const auto first =
        static_cast<std::int64_t>(x) + row * static_cast<std::int64_t>(y) + layer * static_cast<std::int64_t>(z);
    for (const auto corner : {first, first + layer}) {
      mesh.corners.insert(mesh.corners.end(), {corner, corner + 1, corner + row + 1, corner + row});
    }
    mesh.offsets.push_back(mesh.offsets.back() + corners_of_cube);
    mesh.types.push_back(hexahedron);
  });
  return mesh;
}

void write_mesh(Hdf5Writer& file, const CellMesh& mesh) {
  const auto points = mesh.points.size() / 3;
  const auto write_count = [&](const std::string& name, std::size_t count) {
    file.write("/VTKHDF/" + name, std::array{static_cast<std::int64_t>(count)});
  };
  write_count("NumberOfPoints", points);
  write_count("NumberOfCells", mesh.types.size());
  write_count("NumberOfConnectivityIds", mesh.corners.size());
  file.write_compressed("/VTKHDF/Points", std::span<const double>(mesh.points), {points, 3});
  file.write_compressed("/VTKHDF/Connectivity", std::span<const std::int64_t>(mesh.corners), {mesh.corners.size()});
  file.write_compressed("/VTKHDF/Offsets", std::span<const std::int64_t>(mesh.offsets), {mesh.offsets.size()});
  file.write_compressed("/VTKHDF/Types", std::span<const std::uint8_t>(mesh.types), {mesh.types.size()});
}

void write_fields(Hdf5Writer& file, const std::string& group, std::size_t count, const std::vector<MeshField>& fields) {
  for (const auto& field : fields) {
    Hdf5Shape shape{count};
    if (field.components > 1) shape.push_back(field.components);
    std::visit(
        [&](const auto& values) {
          using Value = typename std::decay_t<decltype(values)>::value_type;
          file.write_compressed(group + field.name, std::span<const Value>(values), shape);
        },
        field.values);
  }
}

void write_file(const std::filesystem::path& path, const CellMesh& mesh, const std::vector<MeshField>& cell_fields,
                const std::vector<MeshField>& point_fields, const std::vector<FieldNumber>& numbers) {
  const auto points = mesh.points.size() / 3;
  for (const auto& field : cell_fields) check(path, mesh.types.size(), field);
  for (const auto& field : point_fields) check(path, points, field);
  Hdf5Writer file(path);
  file.create_group("/VTKHDF");
  file.write_attribute("/VTKHDF", "Version", Integers{1, 0});
  file.write_attribute("/VTKHDF", "Type", "UnstructuredGrid");
  for (const auto& [name, value] : numbers) file.write_attribute("/VTKHDF", name, value);
  write_mesh(file, mesh);
  write_fields(file, "/VTKHDF/CellData/", mesh.types.size(), cell_fields);
  write_fields(file, "/VTKHDF/PointData/", points, point_fields);
  file.commit();
}

}  // namespace

void write_vtkhdf(const std::filesystem::path& path, const PlaneLattice& lattice, const std::vector<MeshField>& fields,
                  const std::vector<FieldNumber>& numbers) {
  write_vtkhdf(path, squares_of(lattice), fields, {}, numbers);
}

void write_vtkhdf(const std::filesystem::path& path, const CubeLattice& lattice, const std::vector<MeshField>& fields,
                  const std::vector<FieldNumber>& numbers) {
  write_file(path, cells_of(lattice), fields, {}, numbers);
}

void write_vtkhdf(const std::filesystem::path& path, const PolygonMesh& mesh,
                  const std::vector<MeshField>& polygon_fields, const std::vector<MeshField>& point_fields,
                  const std::vector<FieldNumber>& numbers) {
  check(path, mesh);
  write_file(path, cells_of(mesh), polygon_fields, point_fields, numbers);
}

}  // namespace breccia
