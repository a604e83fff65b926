#pragma once

#include "breccia/films/film_problem.hpp"

#include "films/assembly/film_matrices.hpp"

namespace breccia::films {

/// The matrices of grains and a binder that is resolved by elements of displacements and pressures, several across
/// each film (theory, Eq. 66a). Throws InputError when there is no mesh of the binder (see resolved_mesh()).
[[nodiscard]] FilmMatrices<2> resolved_films(const FilmProblem<2>& problem);

}  // namespace breccia::films
