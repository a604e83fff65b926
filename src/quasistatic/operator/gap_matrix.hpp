#pragma once

#include <span>

#include "quasistatic/operator/elastic_operator.hpp"

namespace breccia::quasistatic {

/// A sparse matrix for the displacements of nodes and the unknowns of gaps, in the order of nodal vectors, without
/// values.
template <int dim>
[[nodiscard]] Matrix make_gap_matrix(const ElasticOperator<dim>& elastic_operator);
/// Adds the stiffness of all cells to a matrix of make_gap_matrix() that is zero. Held components of nodes are coupled
/// to nothing and get this stiffness.
template <int dim>
void assemble_gap_matrix(const ElasticOperator<dim>& elastic_operator, std::span<const Moduli> moduli,
                         double stiffness_of_held, Mat matrix);

}  // namespace breccia::quasistatic
