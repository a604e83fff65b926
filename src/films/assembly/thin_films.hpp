#pragma once

#include "breccia/films/film_problem.hpp"

#include "films/assembly/film_matrices.hpp"

namespace breccia::films {

/// The matrices of grains separated by thin films. A film is a row of elements, whose flows are unknowns of their own
/// (theory, Eqs. 60 to 64). Throws InputError when the films take up a whole grain.
[[nodiscard]] FilmMatrices<2> thin_films(const FilmProblem<2>& problem);

}  // namespace breccia::films
