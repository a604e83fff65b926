#include "benchmark/memory_bandwidth.hpp"

#include "benchmark/stop_watch.hpp"
#include "parallel/reduction.hpp"

namespace breccia {
namespace {

/// Bytes per second of a statement with three array accesses per index, repeated for about `seconds`.
template <class Statement>
double bandwidth_of(double seconds, Clock clock, std::size_t length, int threads, Statement&& statement) {
  double sweeps = 0.0;
  const benchmark::StopWatch watch(clock, threads);
  do {
#pragma omp parallel for num_threads(threads) schedule(static)
    for (std::size_t i = 0; i < length; ++i) statement(i);
    ++sweeps;
  } while (watch.seconds() < seconds);
  return parallel::sum(sweeps * 3.0 * sizeof(double) * static_cast<double>(length) / watch.seconds());
}

}  // namespace

MemoryStreams::MemoryStreams(int threads)
    : threads_(threads), a_(new double[length]), b_(new double[length]), c_(new double[length]) {
  // Each thread initialises its part of the arrays, so that the pages are in its local memory.
#pragma omp parallel for num_threads(threads_) schedule(static)
  for (std::size_t i = 0; i < length; ++i) {
    a_[i] = 0.0;
    b_[i] = 1.0;
    c_[i] = 2.0;
  }
}

MemoryBandwidth MemoryStreams::measure(double seconds, Clock clock) {
  constexpr double s = 0.5;
  double* a = a_.get();
  const double* b = b_.get();
  const double* c = c_.get();
  const auto bandwidth = [&](auto statement) {
    return bandwidth_of(0.5 * seconds, clock, length, threads_, statement);
  };
  return {.triad = bandwidth([=](std::size_t i) { a[i] = b[i] + s * c[i]; }),
          .update = bandwidth([=](std::size_t i) { a[i] = a[i] + s * b[i]; })};
}

}  // namespace breccia
