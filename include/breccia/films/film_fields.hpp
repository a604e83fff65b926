#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "breccia/discretisation/tensor.hpp"

namespace breccia {

/// What a cell of the fields of grains and films is part of.
enum class FilmPart { grain, film, junction };

/// A cell of the fields of grains and films: a triangle of a grain, a quadrilateral of a film between two nodes along
/// it, or the polygon of a junction. Fields are means over the cell, per unit of the load.
struct FilmCell {
  FilmPart part = FilmPart::grain;
  std::size_t corners = 0;  ///< how many of FilmFields::corners are those of this cell
  /// [m^2]; sums of areas times fields are the integrals of the solver. Negative for a junction that is turned over.
  double area = 0.0;
  std::array<double, 3> strain{};  ///< xx, yy, xy; the tensor shear [-]
  std::array<double, 4> stress{};  ///< xx, yy, zz, xy [Pa]
  /// Stress times strain, with the stress and the shear of the flow in a film [Pa]. Its mean over the box is the
  /// modulus, or the compliance under a traction boundary; where all is elastic, twice the density of the energy.
  double work = 0.0;
  /// Of a film, from its first side to its second: the displacement of the one along the film against the other, and
  /// the opening; and the mean displacement by the parabolic flow, beyond that of the sides [m]. Zero elsewhere.
  double slip = 0.0, opening = 0.0, flow = 0.0;
};

/// Fields of grains and films, per unit of the load. Periodic grains are whole, so that they may reach beyond the sides
/// of the box.
struct FilmFields {
  std::vector<Vector<2>> points;        ///< places [m]
  std::vector<Vector<2>> displacement;  ///< of the points [m]
  std::vector<FilmCell> cells;
  std::vector<std::size_t> corners;  ///< points of the cells, one cell after the other, counter-clockwise
};

/// Fields at a time after the load was applied.
struct TimedFilmFields {
  double time = 0.0;  ///< [s]
  FilmFields fields;
};

}  // namespace breccia
