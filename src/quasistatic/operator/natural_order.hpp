#pragma once

#include <span>
#include <vector>

#include "operator/petsc_handle.hpp"

namespace breccia::quasistatic {

// The natural order of the values of a distributed vector is that of the nodes or cells in the box, the first axis
// fastest, whatever the number of processes.

/// All values of a distributed vector in the order of the processes, on the first one; empty on the others.
[[nodiscard]] std::vector<double> on_first_process(Vec distributed);

/// All values of a nodal vector in the natural order, on the first process; empty on the others.
[[nodiscard]] std::vector<double> nodes_in_natural_order(Vec nodal);
/// Sets a nodal vector to values in the natural order, all of which every process has.
void set_nodes(std::span<const double> in_natural_order, Vec nodal);

/// Gives a vector, and its duplicates, the places of the values of this process in the natural order. They are kept as
/// the mapping from local to global numbers, so values must not be set by these.
void set_natural_places(const std::vector<PetscInt>& places, Vec vector);
/// The same for a vector with such places, or on one process without them.
[[nodiscard]] std::vector<double> places_in_natural_order(Vec vector);
void set_places(std::span<const double> in_natural_order, Vec vector);

}  // namespace breccia::quasistatic
