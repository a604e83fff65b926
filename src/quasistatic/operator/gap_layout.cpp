#include "quasistatic/operator/gap_layout.hpp"

#include <algorithm>
#include <array>

#include "parallel/session.hpp"
#include "quasistatic/operator/vector_values.hpp"

namespace breccia::quasistatic {

template <int dim>
GapLayout::GapLayout(const gaps::GapCells<dim>& cells, const IndexRange<dim>& own_nodes,
                     const IndexRange<dim>& own_cells)
    : index_of_(static_cast<std::size_t>(cells.unknowns()), gaps::GapCell<dim>::none) {
  const auto see = [this](std::int32_t number) {
    auto& index = index_of_[static_cast<std::size_t>(number)];
    if (index != gaps::GapCell<dim>::none) return;
    index = static_cast<std::int32_t>(numbers_.size());
    numbers_.push_back(number);
  };
  for_each_index(own_nodes.begin, own_nodes.end, [&](const Index<dim>& node) {
    const auto [begin, end] = cells.unknowns_at(node);
    for (auto number = begin; number < end; ++number) see(number);
  });
  own_ = numbers_.size();
  for_each_index(own_cells.begin, own_cells.end, [&](const Index<dim>& cell) {
    const auto* gap_cell = cells.at(cell);
    if (gap_cell == nullptr) return;
    for (const auto number : gap_cell->gap_unknowns) {
      if (number != gaps::GapCell<dim>::none) see(number);
    }
  });
  // By number: the process that owns an unknown, and its index there.
  std::vector<std::array<int, 2>> places(index_of_.size(), {-1, -1});
  for (std::size_t index = 0; index < own_; ++index) {
    places[static_cast<std::size_t>(numbers_[index])] = {parallel::rank(), static_cast<int>(index)};
  }
  MPI_Allreduce(MPI_IN_PLACE, places.data(), static_cast<int>(2 * places.size()), MPI_INT, MPI_MAX, PETSC_COMM_WORLD);
  std::vector<SharedValues::Copy> copies;
  for (std::size_t index = own_; index < seen(); ++index) {
    const auto& [owner, index_at_owner] = places[static_cast<std::size_t>(numbers_[index])];
    copies.push_back({static_cast<int>(index), owner, index_at_owner});
  }
  if (parallel::ranks() > 1) shared_ = SharedValues(static_cast<int>(seen()), copies);
}

template GapLayout::GapLayout(const gaps::GapCells<2>&, const IndexRange<2>&, const IndexRange<2>&);
template GapLayout::GapLayout(const gaps::GapCells<3>&, const IndexRange<3>&, const IndexRange<3>&);

/// Index of the first value of a gap in a nodal vector.
std::size_t GapLayout::first_in(Vec nodal) const {
  PetscInt size = 0;
  check(VecGetLocalSize(nodal, &size), "reading the size of a vector");
  return static_cast<std::size_t>(size) - own_;
}

std::vector<double> GapLayout::values(Vec nodal) const {
  std::vector<double> values(seen());
  std::copy_n(ReadValues(nodal).data() + first_in(nodal), own_, values.begin());
  shared_.copy_from_owners(std::span(values));
  return values;
}

void GapLayout::set(std::span<const double> values, Vec nodal) const {
  std::copy_n(values.begin(), own_, WriteValues(nodal).data() + first_in(nodal));
}

void GapLayout::add_to_owners(std::span<double> values) const {
  shared_.add_to_owners(values);
  std::ranges::fill(values.subspan(own_), 0.0);
}

void GapLayout::add(std::vector<double> contributions, Vec nodal) const {
  shared_.add_to_owners(contributions);
  const WriteValues values(nodal);
  auto* const own = values.data() + first_in(nodal);
  for (std::size_t index = 0; index < own_; ++index) own[index] += contributions[index];
}

}  // namespace breccia::quasistatic
