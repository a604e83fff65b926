// A test of two processes under mpirun: the first call of the library finds both, they share the cores, and they are
// divided once.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include <omp.h>

#include "breccia/error.hpp"

#include "parallel/common_failure.hpp"
#include "parallel/session.hpp"
#include "parallel/threads.hpp"

namespace {

/// Prints the mistake unless the condition is true.
bool expect(bool holds, const char* wrong) {
  if (!holds) std::puts(wrong);
  return holds;
}

bool is_divided_again() {
  try {
    breccia::parallel::divide(1);
  } catch (const breccia::InputError&) {
    return false;
  }
  return true;
}

/// Whether a failure of the first group, which works alone, is thrown in the other one, too.
bool failures_of_the_first_group_are_common() {
  namespace parallel = breccia::parallel;
  bool has_worked = false;
  parallel::done_by_first_group([&] { has_worked = true; });
  if (has_worked != (parallel::group() == 0)) return false;
  try {
    parallel::done_by_first_group([] { throw breccia::FileError("no space left"); });
  } catch (const breccia::FileError& error) {
    return std::string_view(error.what()) == "no space left";
  }
  return false;
}

}  // namespace

int main() {
  namespace parallel = breccia::parallel;
  bool holds = expect(!parallel::is_alone(), "a process under mpirun takes itself for the only one");
  // Both processes may run on all cores, which they share.
  unsetenv("OMP_NUM_THREADS");
  const int shared = std::min(omp_get_max_threads(), std::max(1, omp_get_num_procs() / 2));
  holds = expect(parallel::threads_for(0) == shared, "two processes do not share the cores") && holds;
  holds = expect(parallel::threads_for(3) == 3, "threads that were asked for are not given") && holds;
  parallel::divide(1);
  holds = expect(parallel::groups() == 2 && parallel::ranks() == 1, "two processes are not two groups") && holds;
  const int group = parallel::group();
  holds = expect(!is_divided_again(), "groups were divided again") && holds;
  holds = expect(parallel::group() == group, "a refusal changed the group") && holds;
  holds =
      expect(failures_of_the_first_group_are_common(), "a failure of the first group is not thrown in all") && holds;
  parallel::stop();
  return holds ? 0 : 1;
}
