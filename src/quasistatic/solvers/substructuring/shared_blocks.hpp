#pragma once

#include <vector>

#include "quasistatic/operator/block_division.hpp"
#include "quasistatic/operator/shared_values.hpp"
#include "quasistatic/solvers/substructuring/block_grid.hpp"

namespace breccia::quasistatic {

/// Numbers of the edges of a process with a block of another one on their other side: the edges at the bottom and on
/// the left, which belong to this process, and those at the top and on the right, which do not.
std::vector<int> edges_between_processes(const BlockGrid& grid);

/// A vertex or an edge at the end of the blocks of this process, which belongs to the next process along an axis.
struct SharedBoundary {
  int number;  ///< number of the vertex or edge
  int owner;   ///< rank of the process that owns it
  int number_at_owner;
  int first_unknown_at_owner;
};

/// The vertices and edges of a process that belong to other processes.
struct SharedBoundaries {
  std::vector<SharedBoundary> vertices, edges;
};

/// The vertices and edges of the process with this rank that belong to other processes.
SharedBoundaries shared_boundaries(const BlockDivision& division, int rank, const UnknownsOfFaces& faces = {});

/// Exchange of the unknowns between blocks of different processes.
SharedValues shared_unknowns(const BlockGrid& grid, const SharedBoundaries& shared);
/// Exchange of values of the edges between processes, in the order of edges_between_processes.
SharedValues shared_edges(const BlockDivision& division, int rank, const SharedBoundaries& shared);

}  // namespace breccia::quasistatic
