#include "films/assembly/film_operator.hpp"

#include <cmath>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "films/assembly/macroscopic.hpp"
#include "films/assembly/resolved_films.hpp"
#include "films/assembly/thin_films.hpp"

namespace breccia::films {
namespace {

/// Components of the unit stress of a load: xx, yy, xy.
Eigen::Vector3d stress_of(Load load) {
  const auto stress = unit_stress<2>(load);
  return {stress.xx, stress.yy, stress.xy};
}

}  // namespace

FilmOperator::FilmOperator(const FilmProblem& problem) : boundary_(problem.boundary) {
  require_sound(problem);
  matrices_ = problem.layers ? resolved_films(problem) : thin_films(problem);
  volume_factors_.compute(matrices_.volume);
  if (volume_factors_.info() != Eigen::Success) {
    throw NumericalError("films: the volumes of films and junctions cannot be inverted; a film may be too thin");
  }
  require_patch(problem.grain.shear);
}

void FilmOperator::require_patch(double grain_shear) const {
  const auto strain = uniform_strain(Load::shear);
  const double grains = work(grain_forces(Load::shear, strain), strain) / grain_shear;
  const double found = grains + work(shear_forces(Load::shear, strain), strain);
  constexpr double rounding = 1e-6;
  if (std::abs(found - area()) <= rounding * area()) return;
  throw NumericalError(fmt::format(
      "films: in a uniform strain grains and films count for {:.6g} times the area that they fill: the elements of a "
      "grain that is all but taken by its films have lost their digits; a film of another thickness, or other sizes, "
      "avoid it, and so do cells",
      found / area()));
}

FilmVector FilmOperator::load_forces(Load load) const {
  if (boundary_ == Boundary::traction) return {0.0, matrices_.tractions * stress_of(load)};
  return {1.0, Eigen::VectorXd::Zero(unknowns())};
}

FilmVector FilmOperator::uniform_strain(Load load) const {
  if (boundary_ != Boundary::traction) return {1.0, Eigen::VectorXd::Zero(unknowns())};
  // The displacement gradient H has this symmetric part, and is rotated so that the held components are zero.
  const auto strain = unit_strain<2>(load);
  const double h21 = -strain.yy * matrices_.farthest_held.y() / matrices_.farthest_held.x();
  const Eigen::Vector4d gradient(strain.xx, 2.0 * strain.xy - h21, h21, strain.yy);
  return {0.0, matrices_.by_gradient * gradient};
}

Eigen::VectorXd FilmOperator::extended(Load load, const FilmVector& displacement) const {
  Eigen::VectorXd whole(unknowns() + FilmMatrices::macroscopic);
  whole << displacement.unknowns(), displacement.macroscopic() * strain_of(load);
  return whole;
}

FilmVector FilmOperator::reduced(Load load, const Eigen::VectorXd& forces) const {
  return {strain_of(load).dot(forces.tail<FilmMatrices::macroscopic>()), forces.head(unknowns())};
}

FilmVector FilmOperator::grain_forces(Load load, const FilmVector& displacement) const {
  return reduced(load, matrices_.grains.selfadjointView<Eigen::Lower>() * extended(load, displacement));
}

FilmVector FilmOperator::shear_forces(Load load, const FilmVector& displacement) const {
  return reduced(load, matrices_.shear.selfadjointView<Eigen::Lower>() * extended(load, displacement));
}

Eigen::VectorXd FilmOperator::volumetric_strains(Load load, const FilmVector& displacement) const {
  return volume_factors_.solve(matrices_.dilatation * extended(load, displacement));
}

FilmVector FilmOperator::bulk_forces(Load load, const FilmVector& displacement) const {
  return reduced(load, matrices_.dilatation.transpose() * volumetric_strains(load, displacement));
}

FilmOperator::Sparse FilmOperator::matrix(const Moduli& binder) const {
  const Sparse stiffness = matrices_.grains + binder.shear * matrices_.shear;
  const int count = unknowns(), all = count + pressures();
  Sparse whole(all, all);
  whole.reserve(stiffness.nonZeros() + matrices_.dilatation.nonZeros() + matrices_.volume.nonZeros());
  for (int column = 0; column < count; ++column) {
    whole.startVec(column);
    for (Sparse::InnerIterator at(stiffness, column); at && at.row() < count; ++at) {
      whole.insertBack(at.row(), column) = at.value();
    }
    for (Sparse::InnerIterator at(matrices_.dilatation, column); at; ++at) {
      whole.insertBack(count + at.row(), column) = -binder.bulk * at.value();
    }
  }
  for (int column = 0; column < pressures(); ++column) {
    whole.startVec(count + column);
    for (Sparse::InnerIterator at(matrices_.volume, column); at; ++at) {
      whole.insertBack(count + at.row(), count + column) = -binder.bulk * at.value();
    }
  }
  whole.finalize();
  return whole;
}

}  // namespace breccia::films
