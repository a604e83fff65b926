#include "breccia/parallel/session.hpp"

#include <array>
#include <cstdlib>

#include <dlfcn.h>
#include <fmt/format.h>
#include <petscsys.h>

#include "breccia/error.hpp"

namespace breccia::parallel {
namespace {

bool is_running() noexcept {
  PetscBool running = PETSC_FALSE;
  return PetscInitialized(&running) == 0 && running == PETSC_TRUE;
}

/// A BLAS with threads of its own gains nothing on sparse factors, spins while our threads work, and rounds differently
/// for another number of them. OpenBLAS is asked by name, since other implementations have no such function.
void keep_blas_to_one_thread() noexcept {
  using SetThreads = void (*)(int);
  // The conversion of a function's address is what dlsym is for.
  const auto set_threads = reinterpret_cast<SetThreads>(dlsym(RTLD_DEFAULT, "openblas_set_num_threads"));
  if (set_threads != nullptr) set_threads(1);
}

}  // namespace

void start() {
  if (is_running()) return;
  keep_blas_to_one_thread();
  int provided = 0;
  // One thread of a process talks to the others; the loops of all threads do not.
  if (MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided) != MPI_SUCCESS) {
    throw NumericalError("MPI does not start on this machine");
  }
  check(PetscInitializeNoArguments(), "starting PETSc");
  // Signals and errors are ours: an error comes back as a code and becomes an exception.
  check(PetscPopSignalHandler(), "setting up PETSc");
  check(PetscPushErrorHandler(PetscIgnoreErrorHandler, nullptr), "setting up PETSc");
}

bool is_under_mpirun() noexcept {
  constexpr std::array variables = {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK"};
  for (const auto* variable : variables) {
    if (std::getenv(variable) != nullptr) return true;
  }
  return false;
}

void set_petsc_options(const std::string& options) {
  start();
  if (PetscOptionsInsertString(nullptr, options.c_str()) != 0) {
    throw InputError(
        fmt::format(R"(PETSc options: cannot read "{}"; expected "-name value -name value ...")", options));
  }
}

void stop() noexcept {
  if (!is_running()) return;
  if (PetscFinalize() != 0) return;
  MPI_Finalize();
}

void abort(int exit_code) noexcept {
  MPI_Abort(PETSC_COMM_WORLD, exit_code);
  std::_Exit(exit_code);
}

int rank() noexcept {
  int number = 0;
  if (is_running()) MPI_Comm_rank(PETSC_COMM_WORLD, &number);
  return number;
}

int ranks() noexcept {
  int count = 1;
  if (is_running()) MPI_Comm_size(PETSC_COMM_WORLD, &count);
  return count;
}

void check(int petsc_error, const char* what) {
  if (petsc_error == 0) return;
  const char* text = nullptr;
  PetscErrorMessage(static_cast<PetscErrorCode>(petsc_error), &text, nullptr);
  throw NumericalError(fmt::format("{}: {}", what, text == nullptr ? "unknown error of PETSc" : text));
}

}  // namespace breccia::parallel
