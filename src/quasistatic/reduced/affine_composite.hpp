#pragma once

#include <concepts>
#include <cstddef>
#include <span>
#include <string>
#include <utility>

#include "breccia/discretisation/boundary.hpp"
#include "breccia/discretisation/load.hpp"
#include "breccia/quasistatic/quasistatic_problem.hpp"
#include "breccia/quasistatic/reduced_response.hpp"

#include "checkpoint/state.hpp"

namespace breccia::quasistatic {

/// A displacement u of a composite: the amplitude a of the affine motion under the unit strain of a load, and all
/// further unknowns. Forces that do work on it are stored in the same form. product() is the scalar product of forces
/// on the unknowns, work() that of forces and displacement.
template <class Vector>
concept DisplacementVector = requires(Vector u, const Vector& other, StateWriter& writer, const StateReader& reader,
                                      const std::string& group) {
  { other.macroscopic() } -> std::convertible_to<double>;
  u.set_macroscopic(1.0);
  u.add(1.0, other);
  u.scale(1.0);
  { product(u, other) } -> std::convertible_to<double>;
  { work(u, other) } -> std::convertible_to<double>;
  save(writer, group, other);
  restore(reader, group, u);
};

/// The function is found by the type of the vector (argument-dependent lookup); a member function of the same name
/// would hide it.
template <DisplacementVector Vector>
void save_vector(StateWriter& state, const std::string& group, const Vector& vector) {
  save(state, group, vector);
}
template <DisplacementVector Vector>
void restore_vector(const StateReader& state, const std::string& group, Vector& vector) {
  restore(state, group, vector);
}

/// A discretised composite whose stiffness is affine in moduli p_i, K(p) = K_0 + sum_i p_i K_i (theory, Eq. 18a). The
/// concept has the functions that a reduced basis needs, for cells as well as for grains and films. volume() is the
/// volume of the box in the unit of the forces; uniform_strain() has the strain of a load everywhere; load_forces() are
/// the force 1 on the macroscopic part or, under a traction boundary, the forces of the unit stress. no_vectors() is an
/// empty list of basis vectors (StoredVectors), in the form that takes the least memory; forces_at_hand is the number
/// of vectors of forces that may be in memory at a time in addition to it, for the products of all vectors with each
/// other.
template <class Composite>
concept AffineComposite = DisplacementVector<typename Composite::Vector> &&
    requires(const Composite& composite, Load load, const typename Composite::Vector& u, std::span<const double> p,
             std::size_t i) {
  { composite.boundary() } -> std::same_as<Boundary>;
  { composite.volume() } -> std::convertible_to<double>;
  // Phases and kinds of the moduli p_i.
  { composite.parameters() } -> std::convertible_to<std::span<const PhaseModulus>>;
  { composite.zero() } -> std::same_as<typename Composite::Vector>;
  { composite.uniform_strain(load) } -> std::same_as<typename Composite::Vector>;
  { composite.load_forces(load) } -> std::same_as<typename Composite::Vector>;
  { composite.constant_forces(load, u) } -> std::same_as<typename Composite::Vector>;  // K_0 u
  { composite.part_forces(i, load, u) } -> std::same_as<typename Composite::Vector>;   // K_i u
  { composite.forces(p, load, u) } -> std::same_as<typename Composite::Vector>;        // K(p) u
  { composite.no_vectors(load) } -> std::same_as<typename Composite::BasisVectors>;
  { Composite::forces_at_hand } -> std::convertible_to<std::size_t>;
};

/// Solves for the displacements of a composite, for one choice of the moduli p_i after the other. solve() starts from a
/// guess and finds the displacement with the macroscopic amplitude 1 or, under a traction boundary, the displacement
/// under the unit stress.
template <class Solver, class Vector>
concept CompositeSolver = requires(Solver& solver, std::span<const double> p, Load load, Vector guess,
                                   const LinearEffort& earlier) {
  solver.prepare(p);
  { solver.solve(load, std::move(guess)) } -> std::same_as<Vector>;
  { solver.effort() } -> std::convertible_to<LinearEffort>;
  solver.count_from(earlier);
};

}  // namespace breccia::quasistatic
