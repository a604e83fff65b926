#include "quasistatic/solvers/lattice/row_exchange.hpp"

#include <algorithm>
#include <cstdint>

#include "parallel/communicator.hpp"
#include "parallel/session.hpp"
#include "quasistatic/operator/plane_division.hpp"

namespace breccia::quasistatic {
namespace {

/// The first row of a process along the second axis; there may be fewer rows than processes.
int first_row_of(int process, int processes, int rows) {
  return static_cast<int>(std::int64_t{rows} * process / processes);
}

}  // namespace

ArrayParts::~ArrayParts() {
  for (auto& type : types_) {
    if (type != MPI_DOUBLE) MPI_Type_free(&type);
  }
}

void ArrayParts::add(const Axes& array, const Axes& part, const Axes& first) {
  MPI_Datatype type = MPI_DOUBLE;
  const bool is_empty = std::ranges::min(part) == 0;
  if (!is_empty) {
    MPI_Type_create_subarray(static_cast<int>(array.size()), array.data(), part.data(), first.data(), MPI_ORDER_C,
                             MPI_DOUBLE, &type);
    MPI_Type_commit(&type);
  }
  counts_.push_back(is_empty ? 0 : 1);
  displacements_.push_back(0);
  types_.push_back(type);
}

RowExchange::RowExchange(const NodeLattice& lattice)
    : is_alone_(lattice.planes == lattice.nodes[2]),
      first_row_(first_row_of(parallel::rank(), parallel::ranks(), lattice.nodes[1])),
      rows_(first_row_of(parallel::rank() + 1, parallel::ranks(), lattice.nodes[1]) - first_row_),
      distance_(lattice.arrays.row),
      plane_(lattice.arrays.plane),
      component_(lattice.size()) {
  if (is_alone_) return;
  plane_ = distance_ * static_cast<std::size_t>(rows_);
  component_ = plane_ * static_cast<std::size_t>(lattice.nodes[2]);
  values_ = allocate_waves(3 * component_ / 2);  // rows have an even number of entries
  make_parts(lattice);
}

void RowExchange::make_parts(const NodeLattice& lattice) {
  const auto& [nodes, row, plane] = lattice.arrays;
  const int width = static_cast<int>(row), processes = parallel::ranks();
  const auto planes = PlaneDivision::among(processes, lattice.nodes[2]).value();
  for (int process = 0; process < processes; ++process) {
    const int first = first_row_of(process, processes, nodes[1]);
    const int rows = first_row_of(process + 1, processes, nodes[1]) - first;
    of_planes_.add({3, nodes[2], nodes[1], width}, {3, lattice.planes, rows, width}, {0, 0, first, 0});
    of_rows_.add({3, lattice.nodes[2], rows_, width}, {3, planes.planes(process), rows_, width},
                 {0, planes.first(process), 0, 0});
  }
}

void RowExchange::give_planes_for_rows(NodalField& field) {
  if (is_alone_) return;
  MPI_Alltoallw(field.all().data(), of_planes_.counts(), of_planes_.displacements(), of_planes_.types(), values(),
                of_rows_.counts(), of_rows_.displacements(), of_rows_.types(), parallel::communicator());
}

void RowExchange::give_rows_for_planes(NodalField& field) {
  if (is_alone_) return;
  MPI_Alltoallw(values(), of_rows_.counts(), of_rows_.displacements(), of_rows_.types(), field.all().data(),
                of_planes_.counts(), of_planes_.displacements(), of_planes_.types(), parallel::communicator());
}

double* RowExchange::row(NodalField& field, std::size_t component, int row) noexcept {
  double* first = is_alone_ ? field.all().data() : values();
  return first + component * component_ + static_cast<std::size_t>(row) * distance_;
}

}  // namespace breccia::quasistatic
