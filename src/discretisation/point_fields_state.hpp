#pragma once

#include <string>
#include <vector>

#include "breccia/discretisation/point_fields.hpp"

#include "checkpoint/state.hpp"

namespace breccia {

/// Saves fields at some times in a group of a state, but for the phases, which the discretisation has. Every process
/// saves those of its cells of the grid. Instantiated for 2 and 3 dimensions.
template <int dim>
void save(StateWriter& state, const std::string& group, const Grid<dim>& grid,
          const std::vector<TimedFields<dim>>& fields);

/// Reads those of some cells. Throws FileError when they are of another discretisation. Instantiated for 2 and 3
/// dimensions.
template <int dim>
[[nodiscard]] std::vector<TimedFields<dim>> read_fields(const StateReader& state, const std::string& group,
                                                        const Discretisation<dim>& discretisation,
                                                        const IndexRange<dim>& cells);

}  // namespace breccia
