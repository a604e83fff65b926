#include "films/assembly/film_operator.hpp"

#include <cmath>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "films/assembly/macroscopic.hpp"
#include "films/assembly/resolved_films.hpp"
#include "films/assembly/thin_films.hpp"
#include "films/space/films_in_space.hpp"
#include "films/space/resolved_in_space.hpp"

namespace breccia::films {
namespace {

/// Components of the unit stress of a load.
template <int dim>
StrainVector<dim> stress_of(Load load) {
  const auto stress = unit_stress<dim>(load);
  StrainVector<dim> components;
  for (int i = 0; i < tensor_components<dim>; ++i) components[i] = component(stress, i);
  return components;
}

FilmMatrices<2> matrices_of(const FilmProblem<2>& problem) {
  return problem.layers ? resolved_films(problem) : thin_films(problem);
}

FilmMatrices<3> matrices_of(const FilmProblem<3>& problem) {
  return problem.layers ? resolved_in_space(problem) : films_in_space(problem);
}

/// The displacement gradient of the unit strain of a load under a traction boundary: it has this symmetric part and is
/// rotated so that the held components are zero.
Eigen::Vector4d gradient_of(const FilmMatrices<2>& matrices, Load load) {
  const auto strain = unit_strain<2>(load);
  const double h21 = -strain.yy * matrices.farthest_held.y() / matrices.farthest_held.x();
  return {strain.xx, 2.0 * strain.xy - h21, h21, strain.yy};
}

}  // namespace

template <int dim>
FilmOperator<dim>::FilmOperator(const FilmProblem<dim>& problem) : boundary_(problem.boundary) {
  require_sound(problem);
  matrices_ = matrices_of(problem);
  volume_factors_.compute(matrices_.volume);
  if (volume_factors_.info() != Eigen::Success) {
    throw NumericalError("films: the volumes of films and junctions cannot be inverted; a film may be too thin");
  }
  require_patch();
}

template <int dim>
void FilmOperator<dim>::require_patch() const {
  const auto strain = uniform_strain(Load::shear);
  const double grains =
      work(grain_forces(Load::shear, strain), strain) * matrices_.content_of_grains / matrices_.shear_of_grains;
  const double found = grains + work(shear_forces(Load::shear, strain), strain);
  constexpr double rounding = 1e-6;
  if (std::abs(found - content()) <= rounding * content()) return;
  throw NumericalError(fmt::format(
      "films: in a uniform strain grains and films count for {:.6g} times the {} that they fill: the elements of a "
      "grain that is all but taken by its films have lost their digits; a film of another thickness, or other sizes, "
      "avoid it, and so do cells",
      found / content(), dim == 2 ? "area" : "volume"));
}

template <int dim>
FilmVector FilmOperator<dim>::load_forces(Load load) const {
  if (boundary_ == Boundary::traction) return {0.0, matrices_.tractions * stress_of<dim>(load)};
  return {1.0, Eigen::VectorXd::Zero(unknowns())};
}

template <int dim>
FilmVector FilmOperator<dim>::uniform_strain(Load load) const {
  // In space no boundary has tractions.
  if constexpr (dim == 2) {
    if (boundary_ == Boundary::traction) return {0.0, matrices_.by_gradient * gradient_of(matrices_, load)};
  }
  return {1.0, Eigen::VectorXd::Zero(unknowns())};
}

template <int dim>
Eigen::VectorXd FilmOperator<dim>::extended(Load load, const FilmVector& displacement) const {
  Eigen::VectorXd whole(unknowns() + Matrices::macroscopic);
  whole << displacement.unknowns(), displacement.macroscopic() * strain_of<dim>(load);
  return whole;
}

template <int dim>
FilmVector FilmOperator<dim>::reduced(Load load, const Eigen::VectorXd& forces) const {
  return {strain_of<dim>(load).dot(forces.template tail<Matrices::macroscopic>()), forces.head(unknowns())};
}

template <int dim>
FilmVector FilmOperator<dim>::grain_forces(Load load, const FilmVector& displacement) const {
  return reduced(load, matrices_.grains.template selfadjointView<Eigen::Lower>() * extended(load, displacement));
}

template <int dim>
FilmVector FilmOperator<dim>::shear_forces(Load load, const FilmVector& displacement) const {
  return reduced(load, matrices_.shear.template selfadjointView<Eigen::Lower>() * extended(load, displacement));
}

template <int dim>
Eigen::VectorXd FilmOperator<dim>::volumetric_strains(Load load, const FilmVector& displacement) const {
  return volume_factors_.solve(matrices_.dilatation * extended(load, displacement));
}

template <int dim>
FilmVector FilmOperator<dim>::bulk_forces(Load load, const FilmVector& displacement) const {
  return reduced(load, matrices_.dilatation.transpose() * volumetric_strains(load, displacement));
}

template <int dim>
typename FilmOperator<dim>::Sparse FilmOperator<dim>::matrix(const Moduli& binder) const {
  const Sparse stiffness = matrices_.grains + binder.shear * matrices_.shear;
  const int count = unknowns(), all = count + pressures();
  Sparse whole(all, all);
  whole.reserve(stiffness.nonZeros() + matrices_.dilatation.nonZeros() + matrices_.volume.nonZeros());
  for (int column = 0; column < count; ++column) {
    whole.startVec(column);
    for (typename Sparse::InnerIterator at(stiffness, column); at && at.row() < count; ++at) {
      whole.insertBack(at.row(), column) = at.value();
    }
    for (typename Sparse::InnerIterator at(matrices_.dilatation, column); at; ++at) {
      whole.insertBack(count + at.row(), column) = -binder.bulk * at.value();
    }
  }
  for (int column = 0; column < pressures(); ++column) {
    whole.startVec(count + column);
    for (typename Sparse::InnerIterator at(matrices_.volume, column); at; ++at) {
      whole.insertBack(count + at.row(), count + column) = -binder.bulk * at.value();
    }
  }
  whole.finalize();
  return whole;
}

template class FilmOperator<2>;
template class FilmOperator<3>;

}  // namespace breccia::films
