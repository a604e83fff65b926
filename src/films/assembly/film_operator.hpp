#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include "breccia/discretisation/load.hpp"
#include "breccia/films/film_problem.hpp"

#include "films/assembly/film_matrices.hpp"
#include "films/assembly/film_vector.hpp"

namespace breccia::films {

/// The stiffness of grains and films in its parts, K = K_0 + G K_G + K K_K (theory, Eq. 65): the grains, and the films
/// for a unit shear and a unit bulk modulus of the binder.
template <int dim>
class FilmOperator {
 public:
  using Matrices = FilmMatrices<dim>;
  using Sparse = typename Matrices::Sparse;

  explicit FilmOperator(const FilmProblem<dim>& problem);

  [[nodiscard]] Boundary boundary() const noexcept { return boundary_; }
  [[nodiscard]] int unknowns() const noexcept {
    return static_cast<int>(matrices_.grains.rows()) - Matrices::macroscopic;
  }
  [[nodiscard]] int pressures() const noexcept { return static_cast<int>(matrices_.volume.rows()); }
  /// FilmMatrices::content
  [[nodiscard]] double content() const noexcept { return matrices_.content; }

  [[nodiscard]] FilmVector zero() const { return {0.0, Eigen::VectorXd::Zero(unknowns())}; }
  /// The uniform strain of a load, without flow in the films.
  [[nodiscard]] FilmVector uniform_strain(Load load) const;
  /// The force 1 on the macroscopic part or, under a traction boundary, the forces of the unit stress of a load on the
  /// boundary.
  [[nodiscard]] FilmVector load_forces(Load load) const;

  /// The forces K_0 u of the grains with their moduli.
  [[nodiscard]] FilmVector grain_forces(Load load, const FilmVector& displacement) const;
  /// K_G u
  [[nodiscard]] FilmVector shear_forces(Load load, const FilmVector& displacement) const;
  /// K_K u
  [[nodiscard]] FilmVector bulk_forces(Load load, const FilmVector& displacement) const;

  /// Volumetric strains of the binder at the positions of its pressures, M^-1 B u (theory, Eq. 65): -1/K times the
  /// pressures.
  [[nodiscard]] Eigen::VectorXd volumetric_strains(Load load, const FilmVector& displacement) const;

  /// Lower triangle of the symmetric matrix of unknowns and pressures -K tr, in units of K, at these moduli of the
  /// binder (theory, Eq. 66).
  [[nodiscard]] Sparse matrix(const Moduli& binder) const;

 private:
  /// A patch test: throws NumericalError where the shear energy of a uniform strain is not that of the content of
  /// grains and binder.
  void require_patch() const;
  [[nodiscard]] Eigen::VectorXd extended(Load load, const FilmVector& displacement) const;
  [[nodiscard]] FilmVector reduced(Load load, const Eigen::VectorXd& forces) const;

  Boundary boundary_;
  Matrices matrices_;
  Eigen::SimplicialLLT<Sparse> volume_factors_;
};

}  // namespace breccia::films
