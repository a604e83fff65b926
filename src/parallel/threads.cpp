#include "parallel/threads.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <vector>

#include <mpi.h>
#include <omp.h>
#include <sched.h>

#include "parallel/communicator.hpp"

namespace breccia::parallel {
namespace {

/// Number of cores for the threads of this process; all until share_cores() has found fewer.
int& own_cores() noexcept {
  static int cores = omp_get_num_procs();
  return cores;
}

/// Whether the user has said how many threads a process has.
bool is_wished_in_environment() noexcept {
  return std::getenv("OMP_NUM_THREADS") != nullptr;
}

/// The cores on which this process may run; none where the system has more than a cpu_set_t can hold.
cpu_set_t allowed_cores() noexcept {
  cpu_set_t cores;
  CPU_ZERO(&cores);
  if (sched_getaffinity(0, sizeof cores, &cores) != 0) CPU_ZERO(&cores);
  return cores;
}

/// Whether both processes may run on some core; true where the cores of one are unknown.
bool meet(const cpu_set_t& one, const cpu_set_t& other) noexcept {
  cpu_set_t common;
  CPU_AND(&common, &one, &other);
  return CPU_COUNT(&common) > 0 || CPU_COUNT(&one) == 0 || CPU_COUNT(&other) == 0;
}

}  // namespace

void share_cores() {
  MPI_Comm machine = MPI_COMM_NULL;
  MPI_Comm_split_type(communicator(), MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
  int processes = 1;
  MPI_Comm_size(machine, &processes);
  const auto own = allowed_cores();
  std::vector<cpu_set_t> all(static_cast<std::size_t>(processes));
  MPI_Allgather(&own, sizeof own, MPI_BYTE, all.data(), sizeof own, MPI_BYTE, machine);
  MPI_Comm_free(&machine);
  // This process is one of them.
  const auto sharing = std::max<std::ptrdiff_t>(
      std::ranges::count_if(all, [&own](const cpu_set_t& other) { return meet(own, other); }), 1);
  own_cores() = std::max(1, omp_get_num_procs() / static_cast<int>(sharing));
}

int threads_for(int asked) {
  if (asked > 0) return asked;
  if (is_wished_in_environment()) return omp_get_max_threads();
  return std::min(omp_get_max_threads(), own_cores());
}

int threads_for(int asked, std::int64_t pieces, std::int64_t least) {
  const int threads = threads_for(asked);
  if (asked > 0 || is_wished_in_environment()) return threads;
  return static_cast<int>(std::clamp<std::int64_t>(pieces / least, 1, threads));
}

}  // namespace breccia::parallel
