#pragma once

#include "breccia/films/film_problem.hpp"

#include "films/assembly/film_matrices.hpp"

namespace breccia::films {

/// The matrices of grains and resolved films in space: Taylor-Hood tetrahedra with quadratic displacements and linear,
/// continuous pressures (theory, Eq. 66a). Throws like films_in_space().
[[nodiscard]] FilmMatrices<3> resolved_in_space(const FilmProblem<3>& problem);

}  // namespace breccia::films
