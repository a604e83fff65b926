#include "parallel/session.hpp"

#include <array>
#include <cstdlib>
#include <new>
#include <numeric>
#include <sstream>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <petscsys.h>
#include <unistd.h>

#include "breccia/error.hpp"

#include "parallel/blas_threads.hpp"
#include "parallel/communicator.hpp"
#include "parallel/threads.hpp"

namespace breccia::parallel {
namespace {

/// The division of the processes into groups.
struct Division {
  int group = 0;
  int groups = 1;
  MPI_Comm communicator = MPI_COMM_NULL;  ///< communicator of this group; null while the processes are not divided
  /// Communicator of the processes of the group on this machine; null until it is first used.
  MPI_Comm on_machine = MPI_COMM_NULL;
};

void free_communicator(MPI_Comm& of_processes) noexcept {
  if (of_processes != MPI_COMM_NULL) MPI_Comm_free(&of_processes);
}

Division& division() noexcept {
  static Division instance;
  return instance;
}

bool is_running() noexcept {
  PetscBool running = PETSC_FALSE;
  return PetscInitialized(&running) == 0 && running == PETSC_TRUE;
}

/// The libraries that this process has started and so must finalise. A host program may have started them before.
struct Started {
  bool mpi = false;
  bool petsc = false;
};

Started& started() noexcept {
  static Started instance;
  return instance;
}

bool is_on_path(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::istringstream directories(path == nullptr ? "" : path);
  for (std::string directory; std::getline(directories, directory, ':');) {
    if (access(fmt::format("{}/{}", directory, program).c_str(), X_OK) == 0) return true;
  }
  return false;
}

/// Without mpirun, Open MPI prepares to start further processes and fails if it finds neither ssh nor rsh. Breccia
/// starts none, so this is switched off.
void start_alone_without_launcher() {
  constexpr int keep_what_is_set = 0;
  if (is_under_mpirun() || is_on_path("ssh") || is_on_path("rsh")) return;
  setenv("OMPI_MCA_ess_singleton_isolated", "1", keep_what_is_set);
}

void start_mpi() {
  int is_initialised = 0;
  MPI_Initialized(&is_initialised);
  if (is_initialised != 0) return;
  start_alone_without_launcher();
  int provided = 0;
  // Only one thread of a process calls MPI.
  if (MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided) != MPI_SUCCESS) {
    throw NumericalError("MPI does not start on this machine");
  }
  started().mpi = true;
}

void start_petsc() {
  // PETSc would take over the signals of the process, and set them back to the default rather than to the handlers that
  // the command or the host program has.
  check(PetscOptionsSetValue(nullptr, "-no_signal_handler", "1"), "setting up PETSc");
  check(PetscInitializeNoArguments(), "starting PETSc");
  started().petsc = true;
  // Error codes of PETSc become exceptions.
  check(PetscPushErrorHandler(PetscIgnoreErrorHandler, nullptr), "setting up PETSc");
}

}  // namespace

void start() {
  if (is_running()) return;
  // A BLAS with threads of its own gains nothing on sparse factors, spins while our threads work, and rounds
  // differently for another number of them.
  static_cast<void>(set_blas_threads(1));
  start_mpi();
  start_petsc();
  share_cores();
}

void divide(int processes_each) {
  start();
  if (!started().petsc) {
    throw InputError("the host program has started PETSc, so its processes cannot be divided into groups");
  }
  if (division().communicator != MPI_COMM_NULL) throw InputError("the processes are divided into groups already");
  const int processes = ranks();
  const char* tasks = std::getenv("SLURM_NTASKS");
  if (processes == 1 && tasks != nullptr && std::atoi(tasks) > 1 && std::getenv("SLURM_PROCID") != nullptr) {
    throw InputError(fmt::format(
        "{} processes were started without a connection by MPI; start them by mpirun, or by srun --mpi=pmix", tasks));
  }
  if (processes_each < 1 || processes % processes_each != 0) {
    throw InputError(fmt::format("{} processes cannot be divided into groups of {}", processes, processes_each));
  }
  int number = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &number);
  free_communicator(division().on_machine);
  division() = {number / processes_each, processes / processes_each};
  // PETSc takes its communicator when it starts, so it must be restarted.
  check(PetscFinalize(), "dividing the processes");
  MPI_Comm_split(MPI_COMM_WORLD, division().group, number, &division().communicator);
  PETSC_COMM_WORLD = division().communicator;
  start_petsc();
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
  const auto begin = options.find_first_not_of(" \t");
  if (begin == std::string::npos || options[begin] != '-') {
    throw InputError(fmt::format(R"(PETSc options: expected "-name value -name value ...", got "{}")", options));
  }
  if (PetscOptionsInsertString(nullptr, options.c_str()) != 0) {
    throw InputError(
        fmt::format(R"(PETSc options: cannot read "{}"; expected "-name value -name value ...")", options));
  }
}

std::vector<std::string> unused_petsc_options() {
  PetscInt count = 0;
  char** names = nullptr;
  char** values = nullptr;
  check(PetscOptionsLeftGet(nullptr, &count, &names, &values), "looking for unused options of PETSc");
  std::vector<std::string> unused;
  unused.reserve(static_cast<std::size_t>(count));
  for (PetscInt i = 0; i < count; ++i) unused.push_back(fmt::format("-{}", names[i]));
  check(PetscOptionsLeftRestore(nullptr, &count, &names, &values), "looking for unused options of PETSc");
  return unused;
}

void stop() noexcept {
  int is_finalised = 0;
  MPI_Finalized(&is_finalised);
  // The host program has finalised MPI before its end: PETSc cannot be finalised any more.
  if (is_finalised != 0) return;
  if (std::exchange(started().petsc, false) && PetscFinalize() != 0) return;
  free_communicator(division().on_machine);
  free_communicator(division().communicator);
  division() = {};
  if (std::exchange(started().mpi, false)) MPI_Finalize();
}

void abort(int exit_code) noexcept {
  int is_initialised = 0;
  MPI_Initialized(&is_initialised);
  if (is_initialised != 0) MPI_Abort(MPI_COMM_WORLD, exit_code);
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

MPI_Comm communicator() noexcept {
  return PETSC_COMM_WORLD;
}

MPI_Comm machine_communicator() {
  auto& machine = division().on_machine;
  if (machine == MPI_COMM_NULL) {
    MPI_Comm_split_type(communicator(), MPI_COMM_TYPE_SHARED, rank(), MPI_INFO_NULL, &machine);
  }
  return machine;
}

int group() noexcept {
  return division().group;
}

int groups() noexcept {
  return division().groups;
}

bool is_alone() noexcept {
  if (!is_running() && is_under_mpirun()) {
    try {
      start();
    } catch (const Error&) {
      return false;
    }
  }
  return ranks() * groups() == 1;
}

bool is_first() noexcept {
  return rank() == 0 && group() == 0;
}

std::vector<std::string> gather(const std::string& text_of_group) {
  if (is_alone()) return {text_of_group};
  // Only the first process of each group contributes its text.
  const std::string contribution = rank() == 0 ? text_of_group : "";
  const auto processes = static_cast<std::size_t>(ranks()) * static_cast<std::size_t>(groups());
  std::vector<int> lengths(processes), offsets(processes);
  const int length = static_cast<int>(contribution.size());
  MPI_Allgather(&length, 1, MPI_INT, lengths.data(), 1, MPI_INT, MPI_COMM_WORLD);
  std::exclusive_scan(lengths.begin(), lengths.end(), offsets.begin(), 0);
  std::string all(static_cast<std::size_t>(offsets.back() + lengths.back()), ' ');
  MPI_Allgatherv(contribution.data(), length, MPI_CHAR, all.data(), lengths.data(), offsets.data(), MPI_CHAR,
                 MPI_COMM_WORLD);
  std::vector<std::string> texts;
  for (std::size_t process = 0; process < processes; process += static_cast<std::size_t>(ranks())) {
    texts.push_back(all.substr(static_cast<std::size_t>(offsets[process]), static_cast<std::size_t>(lengths[process])));
  }
  return texts;
}

std::string text_of_first(const std::string& text) {
  if (ranks() == 1) return text;
  auto length = static_cast<int>(text.size());
  MPI_Bcast(&length, 1, MPI_INT, 0, PETSC_COMM_WORLD);
  auto shared = text;
  shared.resize(static_cast<std::size_t>(length));
  MPI_Bcast(shared.data(), length, MPI_CHAR, 0, PETSC_COMM_WORLD);
  return shared;
}

void check(int petsc_error, const char* what) {
  if (petsc_error == 0) return;
  if (petsc_error == PETSC_ERR_MEM) throw std::bad_alloc();
  const char* text = nullptr;
  PetscErrorMessage(static_cast<PetscErrorCode>(petsc_error), &text, nullptr);
  throw NumericalError(
      fmt::format("{}: {}", what, text == nullptr ? fmt::format("error {} of PETSc", petsc_error) : std::string(text)));
}

}  // namespace breccia::parallel
