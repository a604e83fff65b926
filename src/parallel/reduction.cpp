#include "breccia/parallel/reduction.hpp"

#include <mpi.h>

#include "breccia/parallel/communicator.hpp"
#include "breccia/parallel/session.hpp"

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

void copy_from_first(std::span<double> values) {
  constexpr int first = 0;
  if (ranks() > 1) MPI_Bcast(values.data(), static_cast<int>(values.size()), MPI_DOUBLE, first, communicator());
}

}  // namespace breccia::parallel
