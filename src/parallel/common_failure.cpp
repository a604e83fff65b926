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

constexpr int lack_of_memory = -1, another_failure = -2, directory_in_use = -3;

Failure description_of(const std::exception_ptr& failure) {
  try {
    std::rethrow_exception(failure);
  } catch (const DirectoryInUse& error) {
    return {directory_in_use, error.what()};
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
  if (failure.kind == directory_in_use) throw DirectoryInUse(failure.message);
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

/// Sends the failure of one of several processes to all of them, and returns it.
Failure failure_of(int process, bool is_own, const std::exception_ptr& own, MPI_Comm processes) {
  auto failure = is_own ? description_of(own) : Failure{};
  auto length = static_cast<int>(failure.message.size());
  MPI_Bcast(&failure.kind, 1, MPI_INT, process, processes);
  MPI_Bcast(&length, 1, MPI_INT, process, processes);
  failure.message.resize(static_cast<std::size_t>(length));
  MPI_Bcast(failure.message.data(), length, MPI_CHAR, process, processes);
  return failure;
}

/// Throws on all of these processes where one of them has failed.
void throw_on_all(const std::exception_ptr& failure, MPI_Comm processes) {
  int number = 0, count = 0;
  MPI_Comm_rank(processes, &number);
  MPI_Comm_size(processes, &count);
  int first = failure ? number : count;
  MPI_Allreduce(MPI_IN_PLACE, &first, 1, MPI_INT, MPI_MIN, processes);
  if (first == count) return;
  const auto common = failure_of(first, first == number, failure, processes);
  if (failure) std::rethrow_exception(failure);
  raise(common);
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
  if (processes_of_group() > 1) throw_on_all(failure, communicator());
  if (failure) std::rethrow_exception(failure);
}

void throw_in_all_groups(const std::exception_ptr& failure) {
  if (groups() == 1) return throw_together(failure);
  throw_on_all(failure, MPI_COMM_WORLD);
}

}  // namespace breccia::parallel
