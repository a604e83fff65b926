#pragma once

#include "breccia/films/film_problem.hpp"

#include "films/assembly/film_matrices.hpp"

namespace breccia::films {

/// The matrices of grains parted by thin films: a row of elements a film, with its flow as unknowns of their own
/// (theory, Eqs. 60 to 64). Throws InputError when a film leaves nothing of a grain.
[[nodiscard]] FilmMatrices thin_films(const FilmProblem& problem);

}  // namespace breccia::films
