#pragma once

#include <exception>
#include <optional>
#include <utility>

#include "parallel/session.hpp"

namespace breccia::parallel {

/// Throws on all processes of the group where one of them has failed: its own failure on a process that has one, and on
/// the other processes an Error with the kind and the message of the first failure. So no process waits for one that
/// has stopped. Each process must call the function; MPI is started under mpirun.
void throw_together(const std::exception_ptr& failure);

/// As throw_together(), but for the processes of all groups, so that no group waits for another one.
void throw_in_all_groups(const std::exception_ptr& failure);

/// Runs an action that may fail on some processes of the group only, and fails on all if it fails on one. Each process
/// must call the function.
template <class Action>
void do_together(const Action& action) {
  std::exception_ptr failure;
  try {
    action();
  } catch (...) {
    failure = std::current_exception();
  }
  throw_together(failure);
}

/// Calls make() on each process of the group and returns its value; fails on all processes if it fails on one. Each
/// process must call the function.
template <class Make>
[[nodiscard]] auto made_by_all(const Make& make) {
  std::optional<decltype(make())> made;
  do_together([&] { made.emplace(make()); });
  return *std::move(made);
}

/// Whether this is the first process of the group. Starts MPI under mpirun, where each process counts as the first one
/// until MPI has started.
[[nodiscard]] bool is_first_of_group();

/// Runs an action, such as writing a file, on the first process of the group only; if it fails there, fails on all.
/// Each process must call the function.
template <class Action>
void done_by_first(const Action& action) {
  do_together([&] {
    if (is_first_of_group()) action();
  });
}

/// Runs an action on the processes of the first group only; if it fails on one of them, fails on the processes of all
/// groups. Each process must call the function.
template <class Action>
void done_by_first_group(const Action& action) {
  std::exception_ptr failure;
  try {
    if (group() == 0) action();
  } catch (...) {
    failure = std::current_exception();
  }
  throw_in_all_groups(failure);
}

}  // namespace breccia::parallel
