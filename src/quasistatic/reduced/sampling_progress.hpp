#pragma once

#include <cstddef>

#include "breccia/progress.hpp"
#include "breccia/quasistatic/sampling_options.hpp"

namespace breccia::quasistatic {

/// The progress of the greedy selection of snapshots, whose share is that of the solutions: those that have been found
/// over those to be expected, since the error falls by about the same factor with each snapshot. It never falls.
class SamplingProgress {
 public:
  SamplingProgress(const SamplingOptions& options, std::size_t loads) : options_(options), loads_(loads) {}

  /// After so many snapshots. `error` is the relative error at the last one before it was added, 1 before one was
  /// measured [-].
  Progress after(int snapshots, double error);
  /// In an iteration of the solution for the next load, after so many snapshots and loads of the next one.
  Progress within_solution(int snapshots, std::size_t loads_done);

 private:
  [[nodiscard]] double expected(int snapshots) const;
  void raise_share(double solved, int snapshots);

  SamplingOptions options_;
  std::size_t loads_;
  double error_ = 1.0;
  double share_ = 0.0;
  int iterations_ = 0;
  std::size_t load_ = 0;  ///< the load of the last iteration
};

}  // namespace breccia::quasistatic
