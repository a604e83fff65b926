#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "io/hdf5.hpp"

namespace breccia {

/// A regular lattice of nx times ny equal squares in the plane.
struct PlaneLattice {
  std::size_t nx = 0;
  std::size_t ny = 0;
  std::array<double, 2> origin{};  ///< lower left corner of the lattice [m]
  double spacing = 0.0;            ///< side of a square [m]
};

/// A regular lattice of equal cubes.
struct CubeLattice {
  std::array<std::size_t, 3> cubes{};  ///< number of cubes along each axis
  std::array<double, 3> origin{};      ///< the corner with the lowest coordinates [m]
  double spacing = 0.0;                ///< side of a cube [m]
};

/// Pieces of several kinds: polygons in the plane, or tetrahedra and wedges in space.
template <int dim>
struct PieceMesh {
  std::vector<std::array<double, std::size_t{dim}>> points;  ///< positions of the points [m]
  /// Indices of the points of the pieces, one piece after the other: of a polygon anticlockwise, of a tetrahedron or a
  /// wedge in the order of VTK, in which the first triangle of a wedge is anticlockwise from outside.
  std::vector<std::int64_t> corners;
  /// Number of corners of each piece: at least three in the plane, four or six in space.
  std::vector<std::int64_t> corner_counts;
};

/// A field on the squares or cubes of a lattice, or on the pieces or points of a mesh: a scalar (1), a vector (3) or
/// a symmetric tensor (6: xx, yy, zz, xy, yz, xz).
struct MeshField {
  std::string name;
  std::size_t components = 1;
  /// Values, with the components fastest, then the pieces or points of the mesh, or the squares or cubes of a row
  /// along x, the rows along y and the layers along z.
  std::variant<std::vector<float>, std::vector<std::uint8_t>> values;
};

/// A number that belongs to all fields, such as the time: it is written as an attribute of the file.
struct FieldNumber {
  std::string name;
  double value;
};

/// A compressed VTKHDF file (version 1.0, UnstructuredGrid with a quadrilateral or hexahedron for each square or cube),
/// which ParaView 5.11 and later open; 5.11 reads neither images of two dimensions nor cell data of images. The fields
/// of the squares or cubes come in parts, since all of them may be larger than the memory. All members throw FileError,
/// also where a part does not fit the lattice.
class VtkhdfFile {
 public:
  VtkhdfFile(const std::filesystem::path& path, const PlaneLattice& lattice, const std::vector<FieldNumber>& numbers);
  VtkhdfFile(const std::filesystem::path& path, const CubeLattice& lattice, const std::vector<FieldNumber>& numbers);

  /// Adds a field of some components (MeshField), float or std::uint8_t, to be filled by write(). Throws InputError for
  /// other components.
  template <class Number>
  void add_field(const std::string& name, std::size_t components);
  /// Writes values of a field, in the order of MeshField, from a square or cube on. Parts that begin and end at
  /// multiples of 16384 take least time.
  template <class Number>
  void write(const std::string& name, std::size_t first, const std::vector<Number>& values);
  /// Gives the complete file its name.
  void commit() { file_.commit(); }

 private:
  std::filesystem::path path_;
  Hdf5Writer file_;
  std::size_t cells_;
};

/// Writes fields of the pieces of a mesh, and of its points, as a VTKHDF file. Throws FileError, and InputError when a
/// field does not fit the mesh, or its numbers of corners do not fit its corners.
template <int dim>
void write_vtkhdf(const std::filesystem::path& path, const PieceMesh<dim>& mesh,
                  const std::vector<MeshField>& piece_fields, const std::vector<MeshField>& point_fields,
                  const std::vector<FieldNumber>& numbers);

}  // namespace breccia
