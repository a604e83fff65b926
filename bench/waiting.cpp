#include "waiting.hpp"

#include <chrono>
#include <ctime>
#include <thread>

#include <dlfcn.h>

namespace {

double processor_seconds() noexcept {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// The calls by which a process looks for messages, with their processor time [s].
class Looks {
 public:
  using Look = void (*)();

  void look_by(Look look) noexcept {
    // MUMPS also looks for messages between its fronts, without waiting. A process that waits does hardly anything
    // between two looks; it takes longer after a sleep, when the caches are cold.
    constexpr double shortest_work = 5e-6, shortest_work_after_sleep = 20e-6;
    const double begin = processor_seconds(), since_last = begin - last_;
    const bool has_worked = since_last > (is_waiting() ? shortest_work_after_sleep : shortest_work);
    looks_ = has_worked ? 0 : looks_ + 1;
    look();
    constexpr auto pause = std::chrono::microseconds(100);
    if (is_waiting()) std::this_thread::sleep_for(pause);
    last_ = processor_seconds();
    waited_ += last_ - begin + (is_waiting() ? since_last : 0.0);
  }

  [[nodiscard]] double waited() const noexcept { return waited_; }

 private:
  [[nodiscard]] bool is_waiting() const noexcept {
    constexpr int patience = 30;
    return looks_ > patience;
  }

  int looks_ = 0;
  double last_ = 0.0, waited_ = 0.0;
};

Looks& looks() noexcept {
  static Looks instance;
  return instance;
}

}  // namespace

double seconds_waited() noexcept {
  return looks().waited();
}

/// The function of Open MPI in which every wait looks for messages, again and again. This function replaces it: it
/// measures the time, and sleeps where a wait is long, so that other processes have the core.
extern "C" void opal_progress() {
  static const auto look = reinterpret_cast<Looks::Look>(dlsym(RTLD_NEXT, "opal_progress"));
  looks().look_by(look);
}
