#pragma once

#include "breccia/discretisation/load.hpp"
#include "breccia/films/film_fields.hpp"
#include "breccia/films/film_problem.hpp"

#include "films/film_composite.hpp"
#include "quasistatic/reduced/composite_state.hpp"

namespace breccia::films {

/// Fields of grains and films in a state under a load (theory, Eqs. 67 to 69). The composite is the one of the problem.
/// Throws like the constructor of the composite, and InputError for resolved films.
[[nodiscard]] FilmFields<2> fields_of(const FilmComposite<2>& composite, const FilmProblem<2>& problem, Load load,
                                      const quasistatic::CompositeState<FilmVector>& state);

}  // namespace breccia::films
