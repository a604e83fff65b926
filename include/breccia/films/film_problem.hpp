#pragma once

#include <optional>
#include <vector>

#include "breccia/discretisation/boundary.hpp"
#include "breccia/discretisation/crystals.hpp"
#include "breccia/discretisation/moduli.hpp"
#include "breccia/films/debonding.hpp"
#include "breccia/microstructure/tessellation.hpp"

namespace breccia {

/// Sizes of the elements of grains and films.
template <int dim>
struct FilmElements;

template <>
struct FilmElements<2> {
  /// Ratio of the longest element along a face to the square root of the area of the smaller grain beside it [-]. With
  /// 0.3 most faces have two elements.
  double face_share = 0.3;
};

template <>
struct FilmElements<3> {
  int divisions = 2;  ///< number of elements along each edge of a grain
};

/// The model of grains and films (theory, section 17): elastic grains, the cells of a tessellation, with films
/// of binder between them. In the plane, in plane strain, the films have one thickness, or one for each pair of grains
/// (LaguerreSites::film_shares); a periodic boundary requires a periodic tessellation, the other boundaries require
/// hard walls, which cut grains and films like a window in a larger body; no film runs along a wall. In space the films
/// have nearly one thickness, the grains have the fraction that they would have between films of this thickness, and
/// the boundary is periodic.
template <int dim>
struct FilmProblem {
  Tessellation<dim> tessellation;
  double thickness = 0.0;  ///< thickness of the films [m]; where they have shares, of a film with a mean share of one
  Moduli grain = {};       ///< moduli of the grains [Pa]
  /// Stiffness of each grain in the axes of the box [Pa], where the grains are crystals; else empty.
  std::vector<StiffnessTensor<3>> crystals = {};
  Boundary boundary = Boundary::periodic;
  FilmElements<dim> elements = {};
  /// Number of layers of elements that resolve the binder across every film (theory, Eq. 66a). If absent, films are
  /// thin and have one row of elements each.
  std::optional<int> layers = {};
  DebondedFilms<dim> debonded = {};  ///< with a periodic boundary; with layers, open ones alone
};

/// Throws InputError with all mistakes: a thickness, a share, a modulus or a number of layers that is not positive,
/// crystals that are not one for each grain, a boundary that does not fit the walls of the tessellation, debonded films
/// with another boundary than a periodic one or, with layers, of another kind than open ones, springs without a
/// stiffness.
template <int dim>
void require_sound(const FilmProblem<dim>& problem);

}  // namespace breccia
