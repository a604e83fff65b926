#pragma once

#include <array>

#include "breccia/discretisation/load.hpp"
#include "breccia/discretisation/moduli.hpp"

#include "films/film_composite.hpp"
#include "quasistatic/reduced/composite_state.hpp"

namespace breccia::test {

/// The state of grains and films with an elastic binder under a load.
template <int dim>
quasistatic::CompositeState<films::FilmVector> elastic_state(const films::FilmComposite<dim>& composite,
                                                             const Moduli& binder, Load load) {
  using Composite = films::FilmComposite<dim>;
  films::FilmSolver<dim> solver(composite);
  solver.prepare(std::array{binder.shear, binder.bulk});
  const auto displacement = solver.solve(load, composite.zero());
  quasistatic::CompositeState<films::FilmVector> state{displacement, {displacement, displacement}};
  state.applied[Composite::shear].scale(binder.shear);
  state.applied[Composite::bulk].scale(binder.bulk);
  return state;
}

}  // namespace breccia::test
