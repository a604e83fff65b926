#pragma once

#include <array>

#include <Eigen/Core>

namespace breccia::films {

/// A stretch of a film between two grains: a quadrilateral whose two sides are parallel, or a triangle.
struct FilmStretch {
  std::array<std::array<Eigen::Vector2d, 2>, 2> ends;  ///< start and end of each side
  Eigen::Vector2d direction;                           ///< direction along the film, of length 1
  Eigen::Vector2d normal;                              ///< direction from the first side to the second, of length 1
  double thickness;
};

/// Matrices of a stretch of film (theory, Eqs. 60 and 61). Its unknowns are the displacements of six nodes, two
/// components each: start, middle and end of the first side, then of the second; then the flow at its start and at its
/// end. Its pressures are at the start, the middle and the end.
struct FilmElement {
  static constexpr int displacements = 12, flows = 2, pressures = 3, unknowns = displacements + flows;

  Eigen::Matrix<double, unknowns, unknowns> shear;        ///< stiffness of a unit shear modulus
  Eigen::Matrix<double, pressures, unknowns> dilatation;  ///< volume change, weighted by the functions of the pressure
  Eigen::Matrix<double, pressures, pressures> volume;     ///< integrals of products of these functions
};

[[nodiscard]] FilmElement film_element(const FilmStretch& stretch);
/// The matrices of a stretch whose binder slides along its second side (theory, Eq. 61a).
[[nodiscard]] FilmElement sliding_film_element(const FilmStretch& stretch);

}  // namespace breccia::films
