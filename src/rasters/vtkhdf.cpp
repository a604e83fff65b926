#include "rasters/vtkhdf.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <span>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "io/hdf5.hpp"

namespace breccia {

namespace {

using Integers = std::vector<std::int64_t>;

void check_components(const std::filesystem::path& path, const std::string& name, std::size_t components) {
  if (components == 1 || components == 3 || components == 6) return;
  throw InputError(fmt::format("{}: field {}: expected 1, 3 or 6 components, got {}", path.string(), name, components));
}

void check(const std::filesystem::path& path, std::size_t count, const MeshField& field) {
  const auto size = std::visit([](const auto& values) { return values.size(); }, field.values);
  const auto expected = count * field.components;
  check_components(path, field.name, field.components);
  if (size != expected) {
    throw InputError(
        fmt::format("{}: field {}: expected {} values, got {}", path.string(), field.name, expected, size));
  }
}

/// The type of a piece in VTK: VTK_TRIANGLE, VTK_QUAD or VTK_POLYGON in the plane, VTK_TETRA or VTK_WEDGE in space; 0
/// for another number of corners.
template <int dim>
std::uint8_t vtk_type(std::int64_t corners) {
  constexpr std::uint8_t none = 0, triangle = 5, polygon = 7, quadrilateral = 9, tetrahedron = 10, wedge = 13;
  if constexpr (dim == 3) {
    if (corners == 4) return tetrahedron;
    return corners == 6 ? wedge : none;
  }
  if (corners < 3) return none;
  if (corners == 3) return triangle;
  return corners == 4 ? quadrilateral : polygon;
}

template <int dim>
void check(const std::filesystem::path& path, const PieceMesh<dim>& mesh) {
  const auto sum = std::accumulate(mesh.corner_counts.begin(), mesh.corner_counts.end(), std::int64_t{0});
  const auto points = static_cast<std::int64_t>(mesh.points.size());
  const bool has_all_points =
      std::ranges::all_of(mesh.corners, [points](std::int64_t point) { return point >= 0 && point < points; });
  const bool has_types =
      std::ranges::all_of(mesh.corner_counts, [](std::int64_t corners) { return vtk_type<dim>(corners) != 0; });
  if (sum == static_cast<std::int64_t>(mesh.corners.size()) && has_all_points && has_types) return;
  throw InputError(fmt::format("{}: the corners of the pieces do not fit their numbers or the points", path.string()));
}

/// Cells of any kind, in the lists of VTK. The functions return the entries of a list in a range of indices [first,
/// end).
struct CellMesh {
  template <class Number>
  using Part = std::function<std::vector<Number>(std::size_t begin, std::size_t end)>;

  std::size_t points = 0, cells = 0, corners = 0;
  Part<double> coordinates;   ///< coordinates of the points, three each [m]
  Part<std::int64_t> corner;  ///< corners of the cells, one cell after the other
  Part<std::int64_t> offset;  ///< offsets of the corners of each cell, and the number of all corners
  Part<std::uint8_t> cell_type;
};

/// The values of a function of the index in a range of indices [first, end).
template <class ValueAt>
auto values_between(std::size_t begin, std::size_t end, const ValueAt& value_at) {
  std::vector<std::decay_t<decltype(value_at(begin))>> values;
  values.reserve(end - begin);
  for (auto index = begin; index < end; ++index) values.push_back(value_at(index));
  return values;
}

/// A part of a list of entries with `each` numbers.
template <class Number>
CellMesh::Part<Number> part_of(std::vector<Number> all, std::size_t each) {
  return [all = std::move(all), each](std::size_t begin, std::size_t end) {
    return std::vector<Number>(all.begin() + static_cast<std::ptrdiff_t>(each * begin),
                               all.begin() + static_cast<std::ptrdiff_t>(each * end));
  };
}

template <int dim>
CellMesh cells_of(const PieceMesh<dim>& pieces) {
  std::vector<double> coordinates;
  for (const auto& point : pieces.points) {
    coordinates.insert(coordinates.end(), point.begin(), point.end());
    if (dim == 2) coordinates.push_back(0.0);
  }
  Integers offsets = {0};
  std::vector<std::uint8_t> types;
  for (const auto corners : pieces.corner_counts) {
    offsets.push_back(offsets.back() + corners);
    types.push_back(vtk_type<dim>(corners));
  }
  CellMesh mesh;
  mesh.points = pieces.points.size();
  mesh.cells = pieces.corner_counts.size();
  mesh.corners = pieces.corners.size();
  mesh.coordinates = part_of(std::move(coordinates), 3);
  mesh.corner = part_of(pieces.corners, 1);
  mesh.offset = part_of(std::move(offsets), 1);
  mesh.cell_type = part_of(std::move(types), 1);
  return mesh;
}

/// A lattice of cubes, or of squares as one layer of them without thickness.
struct Lattice {
  std::array<std::size_t, 3> cells{}, nodes{};
  std::array<double, 3> origin{};
  double spacing = 0.0;
  std::size_t corners_of_cell = 0;

  explicit Lattice(const CubeLattice& cubes)
      : cells(cubes.cubes), nodes(cubes.cubes), origin(cubes.origin), spacing(cubes.spacing), corners_of_cell(8) {
    for (auto& along : nodes) ++along;
  }
  explicit Lattice(const PlaneLattice& squares)
      : cells({squares.nx, squares.ny, 1}),
        nodes({squares.nx + 1, squares.ny + 1, 1}),
        origin({squares.origin[0], squares.origin[1], 0.0}),
        spacing(squares.spacing),
        corners_of_cell(4) {}

  /// The index along each axis of an entry with a number, the first axis fastest.
  static std::array<std::size_t, 3> index_of(std::size_t number, const std::array<std::size_t, 3>& along) noexcept {
    return {number % along[0], number / along[0] % along[1], number / along[0] / along[1]};
  }
  [[nodiscard]] std::array<double, 3> point(std::size_t node) const noexcept {
    const auto index = index_of(node, nodes);
    auto point = origin;
    for (std::size_t axis = 0; axis < point.size(); ++axis) point[axis] += static_cast<double>(index[axis]) * spacing;
    return point;
  }
  /// A corner of a cell: the corners of its lower face anticlockwise, then those of the upper face.
  [[nodiscard]] std::int64_t corner(std::size_t cell, std::size_t number) const noexcept {
    constexpr std::array<std::size_t, 4> x = {0, 1, 1, 0}, y = {0, 0, 1, 1};
    const auto index = index_of(cell, cells);
    return static_cast<std::int64_t>(index[0] + x[number % 4] +
                                     nodes[0] * (index[1] + y[number % 4] + nodes[1] * (index[2] + number / 4)));
  }
};

std::size_t product(const std::array<std::size_t, 3>& along) noexcept {
  return along[0] * along[1] * along[2];
}

CellMesh cells_of(const Lattice& lattice) {
  constexpr std::uint8_t quadrilateral = 9, hexahedron = 12;
  const auto each = lattice.corners_of_cell;
  const auto type = each == 4 ? quadrilateral : hexahedron;
  const auto cells = product(lattice.cells);
  return {
      .points = product(lattice.nodes),
      .cells = cells,
      .corners = each * cells,
      .coordinates =
          [lattice](std::size_t begin, std::size_t end) {
            std::vector<double> coordinates;
            for (auto node = begin; node < end; ++node) {
              const auto point = lattice.point(node);
              coordinates.insert(coordinates.end(), point.begin(), point.end());
            }
            return coordinates;
          },
      .corner =
          [lattice, each](std::size_t begin, std::size_t end) {
            return values_between(begin, end, [&](std::size_t i) { return lattice.corner(i / each, i % each); });
          },
      .offset =
          [each](std::size_t begin, std::size_t end) {
            return values_between(begin, end, [&](std::size_t i) { return static_cast<std::int64_t>(each * i); });
          },
      .cell_type = [type](std::size_t begin, std::size_t end) { return std::vector<std::uint8_t>(end - begin, type); }};
}

Hdf5Shape shape_of(std::size_t count, std::size_t components) {
  return components == 1 ? Hdf5Shape{count} : Hdf5Shape{count, components};
}

/// Writes a list of `count` entries of some numbers each, part by part.
template <class Number>
void write_list(Hdf5Writer& file, const std::string& name, std::size_t count, std::size_t each,
                const CellMesh::Part<Number>& part) {
  constexpr std::size_t at_once = std::size_t{1} << 20U;
  file.create_compressed<Number>(name, shape_of(count, each));
  for (std::size_t begin = 0; begin < count; begin += at_once) {
    const auto values = part(begin, std::min(count, begin + at_once));
    file.write_part(name, begin, std::span<const Number>(values));
  }
}

void write_mesh(Hdf5Writer& file, const CellMesh& mesh) {
  const auto write_count = [&](const std::string& name, std::size_t count) {
    file.write("/VTKHDF/" + name, std::array{static_cast<std::int64_t>(count)});
  };
  write_count("NumberOfPoints", mesh.points);
  write_count("NumberOfCells", mesh.cells);
  write_count("NumberOfConnectivityIds", mesh.corners);
  write_list(file, "/VTKHDF/Points", mesh.points, 3, mesh.coordinates);
  write_list(file, "/VTKHDF/Connectivity", mesh.corners, 1, mesh.corner);
  write_list(file, "/VTKHDF/Offsets", mesh.cells + 1, 1, mesh.offset);
  write_list(file, "/VTKHDF/Types", mesh.cells, 1, mesh.cell_type);
}

void begin_file(Hdf5Writer& file, const CellMesh& mesh, const std::vector<FieldNumber>& numbers) {
  file.create_group("/VTKHDF");
  file.write_attribute("/VTKHDF", "Version", Integers{1, 0});
  file.write_attribute("/VTKHDF", "Type", "UnstructuredGrid");
  for (const auto& [name, value] : numbers) file.write_attribute("/VTKHDF", name, value);
  write_mesh(file, mesh);
}

void write_fields(Hdf5Writer& file, const std::string& group, std::size_t count, const std::vector<MeshField>& fields) {
  for (const auto& field : fields) {
    std::visit(
        [&](const auto& values) {
          using Value = typename std::decay_t<decltype(values)>::value_type;
          file.create_compressed<Value>(group + field.name, shape_of(count, field.components));
          file.write_part(group + field.name, 0, std::span<const Value>(values));
        },
        field.values);
  }
}

constexpr auto of_cells = "/VTKHDF/CellData/";

void write_file(const std::filesystem::path& path, const CellMesh& mesh, const std::vector<MeshField>& cell_fields,
                const std::vector<MeshField>& point_fields, const std::vector<FieldNumber>& numbers) {
  for (const auto& field : cell_fields) check(path, mesh.cells, field);
  for (const auto& field : point_fields) check(path, mesh.points, field);
  Hdf5Writer file(path);
  begin_file(file, mesh, numbers);
  write_fields(file, of_cells, mesh.cells, cell_fields);
  write_fields(file, "/VTKHDF/PointData/", mesh.points, point_fields);
  file.commit();
}

}  // namespace

VtkhdfFile::VtkhdfFile(const std::filesystem::path& path, const PlaneLattice& lattice,
                       const std::vector<FieldNumber>& numbers)
    : path_(path), file_(path), cells_(lattice.nx * lattice.ny) {
  begin_file(file_, cells_of(Lattice(lattice)), numbers);
}

VtkhdfFile::VtkhdfFile(const std::filesystem::path& path, const CubeLattice& lattice,
                       const std::vector<FieldNumber>& numbers)
    : path_(path), file_(path), cells_(product(lattice.cubes)) {
  begin_file(file_, cells_of(Lattice(lattice)), numbers);
}

template <class Number>
void VtkhdfFile::add_field(const std::string& name, std::size_t components) {
  check_components(path_, name, components);
  file_.create_compressed<Number>(of_cells + name, shape_of(cells_, components));
}

template <class Number>
void VtkhdfFile::write(const std::string& name, std::size_t first, const std::vector<Number>& values) {
  file_.write_part(of_cells + name, first, std::span<const Number>(values));
}

template void VtkhdfFile::add_field<float>(const std::string&, std::size_t);
template void VtkhdfFile::add_field<std::uint8_t>(const std::string&, std::size_t);
template void VtkhdfFile::write(const std::string&, std::size_t, const std::vector<float>&);
template void VtkhdfFile::write(const std::string&, std::size_t, const std::vector<std::uint8_t>&);

template <int dim>
void write_vtkhdf(const std::filesystem::path& path, const PieceMesh<dim>& mesh,
                  const std::vector<MeshField>& piece_fields, const std::vector<MeshField>& point_fields,
                  const std::vector<FieldNumber>& numbers) {
  check(path, mesh);
  write_file(path, cells_of(mesh), piece_fields, point_fields, numbers);
}

template void write_vtkhdf(const std::filesystem::path&, const PieceMesh<2>&, const std::vector<MeshField>&,
                           const std::vector<MeshField>&, const std::vector<FieldNumber>&);
template void write_vtkhdf(const std::filesystem::path&, const PieceMesh<3>&, const std::vector<MeshField>&,
                           const std::vector<MeshField>&, const std::vector<FieldNumber>&);

}  // namespace breccia
