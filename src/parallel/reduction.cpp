#include "parallel/reduction.hpp"

#include <mpi.h>

#include "parallel/communicator.hpp"
#include "parallel/session.hpp"

namespace breccia::parallel {
namespace {

double reduced(double value, MPI_Op operation) {
  if (ranks() > 1) MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, operation, communicator());
  return value;
}

}  // namespace

double sum(double value) {
  return reduced(value, MPI_SUM);
}

double largest(double value) {
  return reduced(value, MPI_MAX);
}

bool is_first_largest(double value) {
  if (ranks() == 1) return true;
  struct {
    double value;
    int rank;
  } first = {value, rank()};
  MPI_Allreduce(MPI_IN_PLACE, &first, 1, MPI_DOUBLE_INT, MPI_MAXLOC, communicator());
  return first.rank == rank();
}

void sum_in_order(std::span<double> sums, const std::function<void(std::span<double>)>& add) {
  if (ranks() == 1) return add(sums);
  const auto count = static_cast<int>(sums.size());
  const int last = ranks() - 1, tag = 0;
  if (rank() > 0) MPI_Recv(sums.data(), count, MPI_DOUBLE, rank() - 1, tag, communicator(), MPI_STATUS_IGNORE);
  add(sums);
  if (rank() < last) MPI_Send(sums.data(), count, MPI_DOUBLE, rank() + 1, tag, communicator());
  MPI_Bcast(sums.data(), count, MPI_DOUBLE, last, communicator());
}

void copy_from_first(std::span<double> values) {
  constexpr int first = 0;
  if (ranks() > 1) MPI_Bcast(values.data(), static_cast<int>(values.size()), MPI_DOUBLE, first, communicator());
}

}  // namespace breccia::parallel
