#pragma once

#include "films/fields/film_recovery.hpp"

namespace breccia::films {

template <>
FilmRecovery<3>::FilmRecovery(const FilmComposite<3>& composite, const FilmProblem<3>& problem);
template <>
FilmFields<3> FilmRecovery<3>::fields(Load load, const quasistatic::CompositeState<FilmVector>& state) const;

}  // namespace breccia::films
