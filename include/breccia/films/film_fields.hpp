#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "breccia/discretisation/tensor.hpp"

namespace breccia {

/// The kind of region to which a cell of the fields of grains and films belongs.
enum class FilmPart {
  grain,
  film,
  junction,
  gap  ///< a film that is debonded and carries nothing
};

/// A cell of the fields of grains and films: a triangle of a grain, a quadrilateral of a film or a gap between two
/// nodes along it, or the polygon of a junction. Fields are means over the cell, per unit of the load.
struct FilmCell {
  FilmPart part = FilmPart::grain;
  std::size_t corners = 0;  ///< number of its corners, in FilmFields::corners
  /// Area [m^2]; sums of areas times fields are the integrals of the solver. Negative for a junction that is inverted.
  double area = 0.0;
  std::array<double, 3> strain{};  ///< xx, yy, xy; the tensor shear [-]
  std::array<double, 4> stress{};  ///< xx, yy, zz, xy [Pa]
  /// Stress times strain, including the shear of the flow in a film [Pa]. Its mean over the box is the modulus, or the
  /// compliance under a traction boundary; where all phases are elastic it is twice the energy density.
  double work = 0.0;
  /// Displacements in a film [m], zero elsewhere: that of its second side relative to the first, along the film (slip)
  /// and across it (opening), and the mean displacement of the parabolic flow relative to the mean of the sides.
  double slip = 0.0, opening = 0.0, flow = 0.0;
};

/// Fields of grains and films, per unit of the load. Periodic grains are whole, so that they may reach beyond the sides
/// of the box.
struct FilmFields {
  std::vector<Vector<2>> points;        ///< positions of the corner points [m]
  std::vector<Vector<2>> displacement;  ///< displacements of the points [m]
  std::vector<FilmCell> cells;
  /// Indices of the corner points of the cells, one cell after the other, counter-clockwise.
  std::vector<std::size_t> corners;
};

/// Fields at a time after the load was applied.
struct TimedFilmFields {
  double time = 0.0;  ///< [s]
  FilmFields fields;
};

}  // namespace breccia
