#pragma once

#include <chrono>

#include "breccia/homogenisation/stage_microstructure.hpp"
#include "breccia/microstructure/packing.hpp"
#include "breccia/microstructure/random_sequential.hpp"

#include "checkpoint/checkpoint.hpp"

namespace breccia {

/// Runs the packing of a stage, if it has a random one, from the beginning or from the state of an earlier run, and
/// measures the time.
class PackingRunner {
 public:
  PackingRunner(const Stage& stage, const ProgressObserver& follow, Checkpoint* checkpoint);

  /// Runs a packing of balls. Throws FileError where the state of an earlier run does not belong to this packing.
  /// Instantiated for 2 and 3 dimensions.
  template <int dim>
  Packing<dim> run(const PackingRequest& request);

  /// Runs a packing whose state is not saved. Instantiated for both requests.
  template <class Request>
  void run(SequentialRun<Request>& packing);

  /// Wall time [s], including that of earlier runs.
  [[nodiscard]] double seconds() const;

 private:
  template <int dim>
  [[nodiscard]] PackingRun<dim> go_on(const PackingRequest& request) const;

  void report(const PackingProgress& packing) const;

  const Stage& stage_;
  const ProgressObserver& follow_;
  Checkpoint* checkpoint_;
  const StateReader* earlier_;
  double seconds_before_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace breccia
