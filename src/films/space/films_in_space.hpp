#pragma once

#include "breccia/films/film_problem.hpp"

#include "films/assembly/film_matrices.hpp"

namespace breccia::films {

/// The matrices of grains and thin films in space (theory, section 17). Throws InputError when a grain or a film
/// vanishes or the cells do not agree on their vertices.
[[nodiscard]] FilmMatrices<3> films_in_space(const FilmProblem<3>& problem);

}  // namespace breccia::films
