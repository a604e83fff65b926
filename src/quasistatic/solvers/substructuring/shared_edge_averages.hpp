#pragma once

#include <vector>

#include "quasistatic/solvers/substructuring/edge_averages.hpp"
#include "quasistatic/solvers/substructuring/packed_symmetric.hpp"
#include "quasistatic/solvers/substructuring/substructures.hpp"

namespace breccia::quasistatic {

/// Finds the averages of the edges between processes, by kind of edge, where those of other edges stand already. The
/// process to which an edge belongs finds them, so that both processes have the same ones.
void average_shared_edges(const Substructures& blocks, const std::vector<PackedSymmetric<double>>& condensed,
                          double tolerance, std::vector<EdgeAverage>& averages);

}  // namespace breccia::quasistatic
