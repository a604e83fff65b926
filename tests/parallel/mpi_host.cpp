// A program that has started MPI before it uses Breccia, and goes on with MPI afterwards.

#include <cstdio>

#include <mpi.h>

#include "parallel/session.hpp"

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  breccia::parallel::start();
  const bool is_alone = breccia::parallel::is_alone();
  breccia::parallel::stop();
  int is_finalised = 1;
  MPI_Finalized(&is_finalised);
  if (is_finalised != 0) {
    std::puts("the library has ended MPI, which it has not started");
    return 1;
  }
  int size = 0;
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  MPI_Finalize();
  return is_alone && size == 1 ? 0 : 1;
}
