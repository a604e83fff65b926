#pragma once

#include <cstddef>
#include <vector>

namespace breccia::dynamics {

/// How many threads take steps together. Since they wait for one another at every step, all are as slow as one that
/// another program displaces, and slower: two threads that share two cores with two busy programs mostly wait for each
/// other, and one thread alone is many times faster. So threads are left out as long as they would not have a core to
/// themselves. Now and then all are tried again, and stay if they are faster; trials take a small share of the time.
class Crew {
 public:
  explicit Crew(int most_threads);

  [[nodiscard]] int threads() const noexcept { return threads_; }

  /// How a thread fared.
  struct Time {
    double displaced = 0.0;  ///< ready to run, while something else had its core [s]
    double wall = 0.0;       ///< [s]
  };
  /// Adds to the time of a thread; threads may do so at once.
  void add(std::size_t thread, const Time& time);
  /// After each piece of work, of so many steps: sets the number of threads for the next.
  void judge(int steps);

 private:
  void judge_all(double speed, double wall);
  void judge_some(double wall);
  void leave_out(int threads, double wall);

  int most_;
  int threads_;
  std::vector<Time> times_;  ///< by thread, since the last judgement
  double steps_ = 0.0;       ///< since the last judgement
  // Of the threads that are left when others are left out:
  int some_threads_ = 0;
  double some_steps_ = 0.0;  ///< 0: nothing is known about their speed
  double some_wall_ = 0.0;   ///< for these steps [s]
  double rest_ = 0.0;        ///< until all are tried again [s]
};

/// The number of threads that get most done, if thread i of all had a core for a share of the time, and threads work
/// only while all that take part have one. What displaced them shares the cores with fewer threads, too.
int best_number_of_threads(const std::vector<double>& shares);

/// Time of the calling thread since the watch was made.
class ThreadWatch {
 public:
  ThreadWatch();
  [[nodiscard]] Crew::Time time() const;
  /// The wall time alone [s], at a small part of the cost.
  [[nodiscard]] double wall() const;

 private:
  Crew::Time start_;
};

}  // namespace breccia::dynamics
