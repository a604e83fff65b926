#pragma once

#include <atomic>
#include <exception>

namespace breccia::parallel {

/// Carries an exception out of a parallel region of OpenMP, which ends the program without a message where an exception
/// leaves it: std::bad_alloc where memory is short, for example. Every piece of work of the region goes through run();
/// rethrow() follows the region.
class FirstException {
 public:
  /// Calls work() unless another piece of work has thrown, and keeps the first exception of all threads.
  template <class Work>
  void run(const Work& work) noexcept {
    if (has_thrown_.load(std::memory_order_relaxed)) return;
    try {
      work();
    } catch (...) {
      if (!has_thrown_.exchange(true)) exception_ = std::current_exception();
    }
  }

  /// Throws the exception that was kept, if there is one.
  void rethrow() const {
    if (exception_ != nullptr) std::rethrow_exception(exception_);
  }

 private:
  std::atomic<bool> has_thrown_ = false;
  std::exception_ptr exception_ = nullptr;
};

}  // namespace breccia::parallel
