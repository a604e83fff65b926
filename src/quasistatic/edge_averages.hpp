#pragma once

#include <Eigen/Dense>

#include "block_grid.hpp"

namespace breccia::quasistatic {

/// One of the two blocks at an edge: its condensed stiffness, and where in it the edge is.
struct BlockAtEdge {
  const Eigen::MatrixXd* condensed;
  Block shape;
  Side side;
};

/// How the displacements that two blocks want for their common edge become one (theory, Eqs. 38 and 39).
struct EdgeAverage {
  /// Weight of the lower block, D = (S1 + S2)^-1 S1; the upper one has the rest.
  Eigen::MatrixXd lower_weight;
  /// Columns q: both blocks must have the same q'u.
  Eigen::MatrixXd constraints;
};

/// Averages with constraints for what averaging would make more costly by more than a factor `tolerance`.
EdgeAverage average_at_edge(const BlockAtEdge& lower, const BlockAtEdge& upper, double tolerance);

}  // namespace breccia::quasistatic
