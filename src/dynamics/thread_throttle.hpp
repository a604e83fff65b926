#pragma once

#include <cstddef>
#include <vector>

namespace breccia::dynamics {

/// Decides how many threads take steps together. Since threads wait for one another in every step, all of them are as
/// slow as one whose core another program uses, and slower: two threads that share two cores with two busy programs
/// mostly wait for each other, and one thread alone is many times faster. So threads are left out while they would not
/// have a core to themselves. From time to time all threads are tried again, and are kept if they are faster; such
/// trials take a small share of the time.
class ThreadThrottle {
 public:
  explicit ThreadThrottle(int most_threads);

  [[nodiscard]] int threads() const noexcept { return threads_; }

  /// Time that a thread has spent.
  struct Time {
    double displaced = 0.0;  ///< ready to run, while another program had its core [s]
    double wall = 0.0;       ///< wall time [s]
  };
  /// Adds to the time of a thread; threads may do so at once.
  void record(std::size_t thread, const Time& time);
  /// After a batch of so many steps: sets the number of threads for the next one.
  void adjust(int steps);

 private:
  void adjust_after_all(double speed, double wall);
  void adjust_after_some(double wall);
  void leave_out(int threads, double wall);

  int most_;
  int threads_;
  std::vector<Time> times_;  ///< times by thread, since the last decision
  double steps_ = 0.0;       ///< number of steps since the last decision
  // The last use of only some threads: their number, steps and time.
  int some_threads_ = 0;
  double some_steps_ = 0.0;  ///< number of steps; 0: their speed is not known
  double some_wall_ = 0.0;   ///< wall time of these steps [s]
  double rest_ = 0.0;        ///< wall time until all threads are tried again [s]
};

/// The number of threads that together do the most work. Each thread had a core for a share of the time while all
/// threads were used, and threads work only while each of those that take part has a core. The programs that took the
/// cores share them with fewer threads, too.
int best_number_of_threads(const std::vector<double>& shares);

/// Time of the calling thread since the watch was made.
class ThreadWatch {
 public:
  ThreadWatch();
  [[nodiscard]] ThreadThrottle::Time time() const;
  /// The wall time alone [s]; much cheaper than time().
  [[nodiscard]] double wall() const;

 private:
  ThreadThrottle::Time start_;
};

}  // namespace breccia::dynamics
