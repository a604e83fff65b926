#pragma once

#include <Eigen/Dense>

#include "quasistatic/solvers/substructuring/block_grid.hpp"

namespace breccia::quasistatic {

/// One of the two blocks at an edge: its condensed stiffness, and on which side of it the edge is.
struct BlockAtEdge {
  const Eigen::MatrixXd* condensed = nullptr;
  Block shape = {};
  Side side = bottom;
};

/// Stiffness of one of the two blocks of an edge, in the form that the average over the edge needs.
struct EdgeStiffness {
  Eigen::MatrixXd held;  ///< stiffness of the edge with all other unknowns of the block held
  Eigen::MatrixXd free;  ///< stiffness of the edge and then the two vertices at its ends, with all other unknowns free
};

EdgeStiffness stiffness_at_edge(const BlockAtEdge& block);

/// The averaging of the displacements of two blocks at their common edge (theory, Eqs. 38 and 39).
struct EdgeAverage {
  /// Weight of the lower block, D = (S1 + S2)^-1 S1; the weight of the upper one is I - D.
  Eigen::MatrixXd lower_weight;
  /// The constraints, a column q each: q'u is the same in both blocks.
  Eigen::MatrixXd constraints;
};

/// The averages of an edge, with a constraint for every mode of the jump whose energy the averages would multiply by
/// more than `tolerance`.
EdgeAverage average_at_edge(const EdgeStiffness& lower, const EdgeStiffness& upper, double tolerance);

}  // namespace breccia::quasistatic
