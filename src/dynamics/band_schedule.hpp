#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>

#include "dynamics/band.hpp"
#include "dynamics/layer_exchange.hpp"
#include "dynamics/layer_sums.hpp"
#include "dynamics/nodal_field.hpp"
#include "dynamics/step_counter.hpp"
#include "dynamics/thread_throttle.hpp"

namespace breccia::dynamics {

/// Takes the steps of LayerStep with several threads and processes.
///
/// The layers of cells of a process are dealt to its threads in bands. The layer of nodes between two bands moves after
/// both have given their forces, from the same two sums as any other layer, so results do not depend on the number of
/// threads. Threads have no common barrier in a step: a band waits only for the bands beside it, and for the one above
/// not before its last layer of cells. The layer of nodes between two processes is moved by both, from the same sums.
template <int dim>
class BandSchedule {
 public:
  /// `threads` is the largest number of threads. The layers and the exchange must outlive the schedule.
  BandSchedule(LayerStep<dim>& layers, LayerExchange<dim>& exchange, int threads);

  /// Takes steps from `first` on, storing the averages where each begins.
  void take_steps(std::int64_t first, int steps, Averages<dim>* averages);

  /// Memory of the forces and sums [B].
  [[nodiscard]] std::size_t bytes() const noexcept;

 private:
  int take_batch(std::int64_t first, int most_steps, Averages<dim>* averages);
  void take_step(std::size_t first_band, std::size_t end_band, std::int64_t step, int done);
  void sweep(std::size_t band, std::int64_t step, int done);
  void exchange_forces(int done);
  void move_lowest_layer(std::size_t band, std::int64_t step, int done);
  void move_highest_layer(std::int64_t step, int done);
  void find_averages(std::int64_t first, int done, int steps, Averages<dim>* averages);
  [[nodiscard]] bool wraps() const noexcept { return layers_->problem().boundary == Boundary::periodic; }

  LayerStep<dim>* layers_;
  LayerExchange<dim>* exchange_;
  ForceLayer<dim> from_below_;  ///< forces of the layer of cells below those of this process; zero below the box
  ForceLayer<dim> from_above_;
  std::deque<Band<dim>> bands_;  ///< bands from the lowest to the highest
  ThreadThrottle throttle_;
  // Counters of the steps of a batch that have reached the following points:
  StepCounter exchanged_;  ///< the forces of the neighbours of this process are known
  StepCounter averaged_;   ///< the averages are known
  LayerSums<dim> sums_;
};

}  // namespace breccia::dynamics
