#pragma once

#include <string>
#include <vector>

namespace breccia::parallel {

/// Starts MPI and PETSc in this process, unless they are running. Solvers call it when they first need them, so that
/// other work does not wait for their start. MPI or PETSc that the host program has started is used. Signals keep the
/// handlers that the process has.
/// Throws NumericalError when they cannot be started.
void start();

/// Whether this process is one of several that mpirun started, from the environment variables; does not start MPI.
bool is_under_mpirun() noexcept;

/// Passes options to PETSc, written as on a command line ("-ksp_type cg -ksp_monitor"); starts PETSc.
/// Throws InputError when PETSc cannot read them.
void set_petsc_options(const std::string& options);

/// The names of the options of PETSc that have not been read so far, such as "-ksp_monitr". PETSc must have started.
std::vector<std::string> unused_petsc_options();

/// Divides the processes that mpirun started into groups of `processes_each`. From then on each group works
/// independently: solvers and reductions involve only the processes of one group. Must be called once, before anything
/// is solved. Throws InputError when the number of processes is not a multiple of `processes_each`, when they are
/// divided already, and when the host program has started PETSc, which only the host may finalise.
void divide(int processes_each);

/// Finalises MPI and PETSc if start() has started them; must be called once, as the last call. A host program must
/// finalise those that it has started itself.
void stop() noexcept;

/// Ends all processes of this run with an exit code, after a failure of one process for which the others would wait.
[[noreturn]] void abort(int exit_code) noexcept;

/// Rank of this process in its group, from 0; 0 before start().
int rank() noexcept;
/// Number of processes in the group; 1 before start().
int ranks() noexcept;

/// Number of the group of this process, from 0; 0 before divide().
int group() noexcept;
/// Number of groups; 1 before divide().
int groups() noexcept;

/// Whether this is the only process of the run. Under mpirun MPI is started to find out; false where MPI does not
/// start.
bool is_alone() noexcept;

/// Whether this is the first process of the first group, which writes the messages for all processes.
bool is_first() noexcept;

/// Gathers one text per group, in the order of the groups, on every process. Waits for all groups.
std::vector<std::string> gather(const std::string& text_of_group);

/// Broadcasts a text from the first process of the group to all of its processes. Waits for all of them.
std::string text_of_first(const std::string& text);

/// Throws NumericalError when a PETSc function has returned an error; `what` describes the operation.
void check(int petsc_error, const char* what);

}  // namespace breccia::parallel
