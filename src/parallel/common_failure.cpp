#include "parallel/common_failure.hpp"

#include <new>
#include <stdexcept>
#include <string>
#include <system_error>

#include <mpi.h>

#include "breccia/error.hpp"

#include "parallel/communicator.hpp"
#include "parallel/session.hpp"

namespace breccia::parallel {
namespace {

/// The description of a failure that is sent to other processes: its kind, which is an exit code or one of the values
/// below 0, and its message.
struct Failure {
  int kind;
  std::string message;
};

constexpr int lack_of_memory = -1, another_failure = -2;

Failure description_of(const std::exception_ptr& failure) {
  try {
    std::rethrow_exception(failure);
  } catch (const Error& error) {
    return {static_cast<int>(error.exit_code()), error.what()};
  } catch (const std::system_error& error) {
    return {static_cast<int>(ExitCode::file_failure), error.what()};
  } catch (const std::bad_alloc& error) {
    return {lack_of_memory, error.what()};
  } catch (const std::exception& error) {
    return {another_failure, error.what()};
  } catch (...) {
    return {another_failure, "a failure of another process"};
  }
}

[[noreturn]] void raise(const Failure& failure) {
  if (failure.kind == lack_of_memory) throw std::bad_alloc();
  if (failure.kind == another_failure) throw std::runtime_error(failure.message);
  switch (static_cast<ExitCode>(failure.kind)) {
    case ExitCode::bad_input:
      throw InputError(failure.message);
    case ExitCode::numerical_failure:
      throw NumericalError(failure.message);
    case ExitCode::interrupted:
      throw Interrupted(failure.message);
    default:
      throw FileError(failure.message);
  }
}

/// Sends the failure of one process of the group to all processes, and returns it.
Failure failure_of(int process, const std::exception_ptr& own) {
  auto failure = rank() == process ? description_of(own) : Failure{};
  auto length = static_cast<int>(failure.message.size());
  MPI_Bcast(&failure.kind, 1, MPI_INT, process, communicator());
  MPI_Bcast(&length, 1, MPI_INT, process, communicator());
  failure.message.resize(static_cast<std::size_t>(length));
  MPI_Bcast(failure.message.data(), length, MPI_CHAR, process, communicator());
  return failure;
}

/// The number of processes in the group, where MPI has been started if there are several.
int processes_of_group() {
  if (is_under_mpirun()) start();
  return ranks();
}

}  // namespace

bool is_first_of_group() {
  return processes_of_group() == 1 || rank() == 0;
}

void throw_together(const std::exception_ptr& failure) {
  if (const int processes = processes_of_group(); processes > 1) {
    int first = failure ? rank() : processes;
    MPI_Allreduce(MPI_IN_PLACE, &first, 1, MPI_INT, MPI_MIN, communicator());
    if (first == processes) return;
    const auto common = failure_of(first, failure);
    if (!failure) raise(common);
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace breccia::parallel
