#pragma once

#include <vector>

#include <Eigen/Core>

#include "breccia/films/debonding.hpp"

#include "films/assembly/matrix_assembly.hpp"

namespace breccia::films {

/// Springs between the second side of an element of a film and its grain (theory, Eq. 61b). The displacement of that
/// side is the sum of those of the grain and of the jump across the springs, so that the jumps are unknowns of the
/// element beside the displacements. An element without springs has no jumps.
struct InterfaceSprings {
  std::vector<int> jumps;     ///< numbers of the unknowns: a jump for each displacement of the second side
  Eigen::MatrixXd stiffness;  ///< stiffness of the springs for these jumps
  /// Volume of binder that half of the jumps, its mean motion, drives out at the ends of the film, by pressure and
  /// jump.
  Eigen::MatrixXd outflow;
};

/// The stiffness of springs in units of the side of a box [m].
[[nodiscard]] InterfaceStiffness in_sides_of_the_box(const InterfaceStiffness& springs, double side);

/// The stiffness of the jumps at the nodes of a flat side with this normal of length 1, as many components each as the
/// normal has. `products` are the integrals over the side of the products of the functions of two nodes.
[[nodiscard]] Eigen::MatrixXd spring_stiffness(const InterfaceStiffness& springs, const Eigen::VectorXd& normal,
                                               const Eigen::MatrixXd& products);

/// The jumps alone: they do not take part in a macroscopic strain.
template <int dim>
[[nodiscard]] ElementUnknowns<dim> unknowns_of_jumps(const InterfaceSprings& springs);

/// The unknowns of an element, followed by its jumps.
template <int dim>
[[nodiscard]] ElementUnknowns<dim> with_jumps(const ElementUnknowns<dim>& unknowns, const InterfaceSprings& springs);

/// The volume changes of the unknowns of an element, which begin with the displacements of the first side and of the
/// second, and of its jumps.
[[nodiscard]] Eigen::MatrixXd dilatation_with_jumps(const Eigen::MatrixXd& dilatation, const InterfaceSprings& springs);

/// The stiffness of these unknowns.
[[nodiscard]] Eigen::MatrixXd stiffness_with_jumps(const Eigen::MatrixXd& stiffness, const InterfaceSprings& springs);

}  // namespace breccia::films
