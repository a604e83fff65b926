#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace breccia::test {

using Point = std::array<double, 3>;

/// A triangle of an STL file.
struct StlTriangle {
  Point normal{};
  std::array<Point, 3> corners{};
};

/// Reads a binary STL file. Throws std::runtime_error where its size is not that of its triangles.
std::vector<StlTriangle> parse_stl(std::string_view bytes);

/// The bodies whose surfaces are in a list of triangles, one after the other: a body ends where all its edges have met
/// their opposites. Throws std::runtime_error where an edge is met twice in one direction, or the last body is open.
std::vector<std::vector<StlTriangle>> closed_bodies(const std::vector<StlTriangle>& triangles);

/// The volume inside a closed surface, positive where its triangles are counter-clockwise from outside.
double volume_of(const std::vector<StlTriangle>& body);

/// An element of a file of Gmsh.
struct MshElement {
  int type = 0;    ///< 1 line, 2 triangle, 4 tetrahedron
  int group = 0;   ///< physical group
  int entity = 0;  ///< elementary entity
  std::vector<std::size_t> nodes;
};

/// A periodic pair of entities.
struct MshPeriodic {
  int dimension = 0, entity = 0, master = 0;
  std::array<double, 16> affine{};                ///< maps the master onto the entity
  std::vector<std::array<std::size_t, 2>> nodes;  ///< of the entity and of the master
};

/// The content of a file in the format MSH 2.2.
struct Msh {
  std::map<std::string, std::array<int, 2>> groups;  ///< dimension and number by name
  std::map<std::size_t, Point> nodes;
  std::vector<MshElement> elements;
  std::vector<MshPeriodic> periodic;

  /// The elements of a group.
  [[nodiscard]] std::vector<MshElement> of_group(const std::string& name) const;
  /// The area of a triangle in the plane, or the volume of a tetrahedron; negative where it is inverted.
  [[nodiscard]] double content(const MshElement& element) const;
  /// The sum of the contents of a group.
  [[nodiscard]] double content(const std::string& group) const;
};

/// Reads a text in the format MSH 2.2. Throws std::runtime_error.
Msh parse_msh(const std::string& text);

}  // namespace breccia::test
