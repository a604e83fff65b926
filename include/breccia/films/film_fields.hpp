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
  junction,  ///< the binder between the corners of three or more grains, in space of four
  gap,       ///< a film that is debonded and carries nothing
  channel,   ///< in space, the binder along an edge between three grains
  slip,      ///< a film whose binder slides along one of its sides
  spring     ///< a film whose binder is held to one of its sides by springs; its work is that of the binder and the
             ///< springs
};

/// A cell of the fields of grains and films. In the plane: a triangle of a grain, a quadrilateral of a film or a gap
/// between two nodes along it, or the polygon of a junction. In space: a tetrahedron of a grain or a junction, or a
/// wedge of a film, a gap or a channel, whose first triangle is counter-clockwise from outside. Fields are means over
/// the cell, per unit of the load.
template <int dim>
struct FilmCell {
  FilmPart part = FilmPart::grain;
  std::size_t corners = 0;  ///< number of its corners, in FilmFields::corners
  /// Area [m^2] or volume [m^3]; the integral of a field is the sum of the contents times the field. Negative where a
  /// junction or a channel is inverted.
  double content = 0.0;
  std::array<double, tensor_components<dim>> strain{};  ///< xx, yy, xy or xx, yy, zz, yz, zx, xy; the tensor shears [-]
  std::array<double, dim == 2 ? 4 : 6> stress{};        ///< xx, yy, zz, xy or xx, yy, zz, yz, zx, xy [Pa]
  /// Stress times strain, including the shear of the flow in a film [Pa]. Its mean over the box is the modulus, or the
  /// compliance under a traction boundary; where all phases are elastic it is twice the energy density.
  double work = 0.0;
  /// Displacements in a film [m], zero elsewhere: that of its second side relative to the first, along the film (slip)
  /// and across it (opening), and the mean displacement of the parabolic flow relative to the mean of the sides. In
  /// space, slip and flow are the lengths of vectors along the film.
  double slip = 0.0, opening = 0.0, flow = 0.0;
};

/// Fields of grains and films, per unit of the load. Periodic grains are whole, so that they may reach beyond the sides
/// of the box.
template <int dim>
struct FilmFields {
  std::vector<Vector<dim>> points;        ///< positions of the corner points [m]
  std::vector<Vector<dim>> displacement;  ///< displacements of the points [m]
  std::vector<FilmCell<dim>> cells;
  /// Indices of the corner points of the cells, one cell after the other, in the plane counter-clockwise.
  std::vector<std::size_t> corners;
};

/// Fields at a time after the load was applied.
template <int dim>
struct TimedFilmFields {
  double time = 0.0;  ///< [s]
  FilmFields<dim> fields;
};

}  // namespace breccia
