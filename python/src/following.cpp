#include "following.hpp"

#include <atomic>
#include <mutex>
#include <thread>
#include <variant>

#include "breccia/error.hpp"

#include "parallel/blas_threads.hpp"

namespace breccia::python {

namespace py = pybind11;
using std::chrono::milliseconds;

namespace {

/// The mutex that is held by the thread that calculates.
std::timed_mutex& turn_of_all() {
  static std::timed_mutex instance;
  return instance;
}

/// The identity of the thread that calculates, if there is one.
std::atomic<std::thread::id>& calculating() {
  static std::atomic<std::thread::id> instance;
  return instance;
}

/// Whether the interpreter ends, so that no calculation may begin or go on.
std::atomic<bool>& is_ending() {
  static std::atomic<bool> instance = false;
  return instance;
}

/// Waits a while for the mutex, without the interpreter's lock. Returns whether it is held now.
bool takes_turn() {
  constexpr milliseconds pause(50);
  const py::gil_scoped_release release;
  return turn_of_all().try_lock_for(pause);
}

}  // namespace

Turn::Turn(Following* following) {
  if (calculating() == std::this_thread::get_id()) {
    throw InputError("a calculation cannot be started by a function that another one calls");
  }
  if (following != nullptr) following->ask();
  while (!takes_turn()) {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (following != nullptr) following->ask();
  }
  calculating() = std::this_thread::get_id();
  threads_of_host_ = parallel::set_blas_threads(1);
}

Turn::~Turn() {
  if (threads_of_host_) parallel::set_blas_threads(*threads_of_host_);
  calculating() = std::thread::id();
  turn_of_all().unlock();
}

void end_calculations() {
  is_ending() = true;
  if (calculating() == std::this_thread::get_id()) return;
  const py::gil_scoped_release release;
  turn_of_all().lock();
}

bool Following::is_due(Clock::time_point& last, milliseconds pause) const {
  const auto now = Clock::now();
  if (now - last < pause) return false;
  last = now;
  return true;
}

void Following::look_for_signals() {
  constexpr milliseconds pause(50);
  if (!is_due(looked_, pause)) return;
  const py::gil_scoped_acquire lock;
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  if (is_ending() || (!stop_.is_none() && stop_().cast<bool>())) shall_end_ = true;
}

void Following::report(const Progress& now) {
  constexpr milliseconds pause(100);
  if (!is_due(shown_, pause)) return;
  const py::gil_scoped_acquire lock;
  if (!show_.is_none()) show_(now.what, now.share, now.details);
}

void Following::ask() {
  if (is_ending() || (!stop_.is_none() && stop_().cast<bool>())) {
    throw Interrupted("the calculation was stopped before it began; run() leaves what it has computed");
  }
}

void Following::follow(const Progress& now) {
  look_for_signals();
  if (shall_end_) throw Interrupted("the calculation was stopped and is lost; run() leaves what it has computed");
  report(now);
}

RunObserver Following::run_observer() {
  return {.progress = [this](const Progress& now) { report(now); },
          .event =
              [](const RunEvent& event) {
                const auto* const note = std::get_if<Note>(&event);
                if (note == nullptr) return;
                const py::gil_scoped_acquire lock;
                if (PyErr_WarnEx(PyExc_UserWarning, note->text.c_str(), 1) != 0) throw py::error_already_set();
              }};
}

bool Following::stop() {
  if (interruption_ || shall_end_) return true;
  try {
    look_for_signals();
  } catch (py::error_already_set& raised) {
    const py::gil_scoped_acquire lock;
    interruption_.emplace(raised);
  }
  return interruption_ || shall_end_;
}

void Following::throw_interruption() {
  if (interruption_) throw py::error_already_set(*interruption_);
}

}  // namespace breccia::python
