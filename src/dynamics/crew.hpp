#pragma once

#include <cstddef>
#include <vector>

namespace breccia::dynamics {

/// How many threads take steps together. Since they wait for one another at every step, all are as slow as one that
/// another program displaces: beside it, fewer threads are faster. So threads are left out as long as they would not
/// have a core to themselves, and now and then all are tried again.
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
  /// After each piece of work: sets the number of threads for the next.
  void judge();

 private:
  int most_;
  int threads_;
  double short_for_ = 0.0;   ///< how long threads have been left out [s]
  std::vector<Time> times_;  ///< by thread, since the last judgement
};

/// The number of threads that get most done, if thread i has a core for a share of the time and they work only while
/// all have one.
int best_number_of_threads(std::vector<double> shares);

/// Time of the calling thread since it was made.
class ThreadWatch {
 public:
  ThreadWatch();
  [[nodiscard]] Crew::Time time() const;

 private:
  Crew::Time start_;
};

}  // namespace breccia::dynamics
