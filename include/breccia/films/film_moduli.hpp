#pragma once

#include <span>
#include <vector>

#include "breccia/discretisation/load.hpp"
#include "breccia/films/film_problem.hpp"

namespace breccia {

/// Apparent moduli [Pa] of elastic grains and films, by binder and load: mean stress over mean strain of the box, for
/// binders with these moduli [Pa]. Throws InputError when the problem is not sound (require_sound), a grain vanishes in
/// its films or a modulus of a binder is not positive; NumericalError when a linear system cannot be solved.
template <int dim>
[[nodiscard]] std::vector<std::vector<double>> film_moduli(const FilmProblem<dim>& problem,
                                                           std::span<const Moduli> binders,
                                                           std::span<const Load> loads);

}  // namespace breccia
