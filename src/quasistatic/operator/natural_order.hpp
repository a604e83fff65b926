#pragma once

#include <vector>

#include "breccia/parallel/ordered_values.hpp"

#include "quasistatic/operator/petsc_handle.hpp"

namespace breccia::quasistatic {

// The natural order of the values of a distributed vector is that of the nodes or cells in the box, the first axis
// fastest, whatever the number of processes.

/// Indices of the values of this process in a nodal vector. The vector must outlive them.
[[nodiscard]] parallel::OrderedPlaces natural_indices_of_nodes(Vec nodal);

/// Gives a vector, and its duplicates, the indices of the values of this process in the natural order. They are kept as
/// the vector's mapping from local to global numbers, so that values must not be set by local numbers.
void set_natural_indices(const std::vector<PetscInt>& indices, Vec vector);
/// Indices of the values of this process in a vector for which set_natural_indices() was called; on one process also
/// without that call. The vector must outlive them.
[[nodiscard]] parallel::OrderedPlaces natural_indices(Vec vector);

}  // namespace breccia::quasistatic
