#pragma once

#include <string>
#include <vector>

namespace breccia::parallel {

/// Starts MPI and PETSc in this process, if they do not run yet. Solvers do it when they first need them, so that what
/// needs neither does not wait for them. In a host program that runs MPI, or MPI and PETSc, already, what runs is used.
/// Throws NumericalError when they cannot start.
void start();

/// Whether this process is one of several that mpirun started. Asks the environment alone.
bool is_under_mpirun() noexcept;

/// Hands options to PETSc, written as on a command line ("-ksp_type cg -ksp_monitor"); starts it.
/// Throws InputError when PETSc cannot read them.
void set_petsc_options(const std::string& options);

/// Parts the processes that mpirun started into groups of so many, which work by themselves from now on: what this
/// process does with others is with those of its group. To be called once, before anything is solved.
/// Throws InputError when the processes cannot be so divided.
void divide(int processes_each);

/// Ends in good order what start() has started of MPI and PETSc; to be called once, last. A host program ends by itself
/// what it has started.
void stop() noexcept;

/// Ends all processes of this run with an exit code. For a failure that the others may not share and would wait for.
[[noreturn]] void abort(int exit_code) noexcept;

/// Number of this process in its group, from 0, and how many there are; 0 of 1 before start().
int rank() noexcept;
int ranks() noexcept;

/// Number of the group of this process, from 0, and how many there are; 0 of 1 before divide().
int group() noexcept;
int groups() noexcept;

/// Whether there is no other process, of this group or another.
bool is_alone() noexcept;

/// Whether this is the first process of the first group, which speaks for all.
bool is_first() noexcept;

/// A text from each group, in their order, for every process. Waits for all.
std::vector<std::string> gather(const std::string& text_of_group);

/// A text from the first process of the group, for all of its processes. Waits for all.
std::string text_of_first(const std::string& text);

/// Throws NumericalError when a PETSc function has failed, naming what was tried.
void check(int petsc_error, const char* what);

}  // namespace breccia::parallel
