#pragma once

#include <string>
#include <vector>

#include "breccia/discretisation/point_fields.hpp"

#include "checkpoint/state.hpp"

namespace breccia {

/// Saves fields at some times in a group of a state, without the phases, which the discretisation has. Every process
/// saves the fields of its own cells of the grid. Instantiated for 2 and 3 dimensions.
template <int dim>
void save(StateWriter& state, const std::string& group, const Grid<dim>& grid,
          const std::vector<TimedFields<dim>>& fields);

/// Reads the saved fields of some cells. Throws FileError when they belong to another discretisation. Instantiated for
/// 2 and 3 dimensions.
template <int dim>
[[nodiscard]] std::vector<TimedFields<dim>> read_fields(const StateReader& state, const std::string& group,
                                                        const Discretisation<dim>& discretisation,
                                                        const IndexRange<dim>& cells);

}  // namespace breccia
