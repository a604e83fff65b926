#pragma once

#include <memory>

#include "breccia/discretisation/load.hpp"
#include "breccia/films/film_fields.hpp"
#include "breccia/films/film_problem.hpp"

#include "films/film_composite.hpp"
#include "quasistatic/reduced/composite_state.hpp"

namespace breccia::films {

/// Computes fields of grains and films (theory, Eqs. 67 to 69, in space 69e: films/space/solid_recovery.hpp). It builds
/// their mesh once, for all fields.
template <int dim>
class FilmRecovery {
 public:
  /// The composite is the one of the problem, and must outlive this object. Throws like its constructor, and InputError
  /// for resolved films.
  FilmRecovery(const FilmComposite<dim>& composite, const FilmProblem<dim>& problem);

  /// The fields in a state under a load.
  [[nodiscard]] FilmFields<dim> fields(Load load, const quasistatic::CompositeState<FilmVector>& state) const;

 private:
  /// The problem and what is known of its mesh.
  struct Mesh;

  const FilmComposite<dim>* composite_;
  std::shared_ptr<const Mesh> mesh_;
};

template <>
FilmRecovery<2>::FilmRecovery(const FilmComposite<2>& composite, const FilmProblem<2>& problem);
template <>
FilmFields<2> FilmRecovery<2>::fields(Load load, const quasistatic::CompositeState<FilmVector>& state) const;

}  // namespace breccia::films
