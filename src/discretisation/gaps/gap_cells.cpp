#include "discretisation/gaps/gap_cells.hpp"

#include <utility>

namespace breccia::gaps {

template <int dim>
GapCells<dim>::GapCells(const Grid<dim>& grid, std::vector<GapCell<dim>> cells, std::span<const std::size_t> places,
                        const IndexRange<dim>& nodes, std::vector<std::int32_t> first_unknowns)
    : grid_(grid),
      cells_(std::move(cells)),
      numbers_(grid.cell_count(), GapCell<dim>::none),
      nodes_(nodes),
      first_unknowns_(std::move(first_unknowns)) {
  for (std::size_t number = 0; number < places.size(); ++number) {
    numbers_[places[number]] = static_cast<std::int32_t>(number);
  }
}

template class GapCells<2>;
template class GapCells<3>;

}  // namespace breccia::gaps
