#pragma once

#include <vector>

#include "quasistatic/solvers/substructuring/edge_averages.hpp"
#include "quasistatic/solvers/substructuring/packed_symmetric.hpp"
#include "quasistatic/solvers/substructuring/substructures.hpp"

namespace breccia::quasistatic {

/// Adds the averages of the edges between processes to a list by kind of edge that has those of all other edges. The
/// process to which an edge belongs computes them, so that both processes have the same averages.
void average_shared_edges(const Substructures& blocks, const std::vector<PackedSymmetric<double>>& condensed,
                          double tolerance, std::vector<EdgeAverage>& averages);

}  // namespace breccia::quasistatic
