#include "breccia/parallel/common_failure.hpp"

#include <mpi.h>

#include "breccia/parallel/communicator.hpp"
#include "breccia/parallel/session.hpp"

namespace breccia::parallel {

void throw_if_any(const std::optional<std::string>& mistake) {
  if (ranks() == 1) {
    if (mistake) throw InputError(*mistake);
    return;
  }
  int first = mistake ? rank() : ranks();
  MPI_Allreduce(MPI_IN_PLACE, &first, 1, MPI_INT, MPI_MIN, communicator());
  if (first == ranks()) return;
  auto text = mistake.value_or("");
  auto length = static_cast<int>(text.size());
  MPI_Bcast(&length, 1, MPI_INT, first, communicator());
  text.resize(static_cast<std::size_t>(length));
  MPI_Bcast(text.data(), length, MPI_CHAR, first, communicator());
  throw InputError(text);
}

}  // namespace breccia::parallel
