#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <utility>

#include <pybind11/pybind11.h>

#include "breccia/campaign/run.hpp"
#include "breccia/homogenisation/study_sink.hpp"

namespace breccia::python {

/// Follows a calculation for Python: passes its progress to a function `(what, share, details)`, a few times a second,
/// looks for signals, so that Ctrl-C ends it, and asks a function whether it shall end. It must be made and destroyed
/// with the interpreter's lock held.
class Following {
 public:
  /// `show`, `stop`: the functions, or None.
  explicit Following(pybind11::object show, pybind11::object stop = pybind11::none())
      : show_(std::move(show)), stop_(std::move(stop)) {}

  /// Follows a calculation in memory, which ends at once: by the exception of a signal, or by Interrupted where `stop`
  /// says so.
  void follow(const Progress& now);
  /// Throws Interrupted where `stop` says so. The interpreter's lock must be held.
  void ask();
  /// Functions for a run in a directory, which a signal or `stop` ends after a checkpoint (stop()).
  [[nodiscard]] RunObserver run_observer();
  /// Whether the run shall end: the stop of a CheckpointSchedule.
  [[nodiscard]] bool stop();
  /// Throws the exception that a signal has raised, if a signal has ended the run.
  void throw_interruption();

 private:
  using Clock = std::chrono::steady_clock;

  [[nodiscard]] bool is_due(Clock::time_point& last, std::chrono::milliseconds pause) const;
  /// Looks for signals and calls `stop`; throws the exceptions that they raise.
  void look_for_signals();
  void report(const Progress& now);

  pybind11::object show_, stop_;
  Clock::time_point looked_ = Clock::now(), shown_ = Clock::now() - std::chrono::hours(1);
  std::optional<pybind11::error_already_set> interruption_ = {};
  bool shall_end_ = false;  ///< as `stop`, or the end of the interpreter, has said
};

/// Follows a solution in memory.
class FollowingSink final : public StudySink {
 public:
  /// The argument must outlive this object.
  explicit FollowingSink(Following& following) : following_(following) {}
  void progress(const Progress& now) override { following_.follow(now); }

 private:
  Following& following_;
};

/// The turn of a calculation. Solvers keep state of their own in the process, so one thread calculates at a time;
/// meanwhile the BLAS, which NumPy may share, has one thread. It must be made and destroyed with the interpreter's lock
/// held. Throws the exception that a signal raises while it waits, Interrupted where `following` shall end meanwhile,
/// and InputError where this thread calculates already: in a function that another calculation calls.
class Turn {
 public:
  explicit Turn(Following* following = nullptr);
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;
  Turn(Turn&&) = delete;
  Turn& operator=(Turn&&) = delete;
  ~Turn();

 private:
  std::optional<int> threads_of_host_;
};

/// Does a calculation in its turn, without the interpreter's lock.
template <class Work>
auto calculate(const Work& work, Following* following = nullptr) {
  const Turn turn(following);
  const pybind11::gil_scoped_release release;
  return work();
}

/// Ends the calculation of another thread, waits for it and lets no other one begin: for the end of the interpreter, at
/// which threads that do not keep it from ending (daemon threads) may still calculate. The interpreter's lock must be
/// held.
void end_calculations();

}  // namespace breccia::python
