#include "dynamics/band_schedule.hpp"

#include <algorithm>

#include <omp.h>

namespace breccia::dynamics {
namespace {

/// The least number of points for a thread: with fewer it would mostly wait for other threads.
constexpr std::size_t points_per_thread = 8192;

template <int dim>
int useful_bands(const Discretisation<dim>& discretisation, const LayerExchange<dim>& exchange, int threads) {
  const auto useful = static_cast<int>(discretisation.points() / points_per_thread);
  return std::clamp(std::min(threads, useful), 1, exchange.end() - exchange.first());
}

}  // namespace

template <int dim>
BandSchedule<dim>::BandSchedule(LayerStep<dim>& layers, LayerExchange<dim>& exchange, int threads)
    : layers_(&layers),
      exchange_(&exchange),
      from_below_(layers.nodes().layer_size()),
      from_above_(layers.nodes().layer_size()),
      throttle_(1),
      sums_(layers.problem().discretisation.grid()) {
  const int first = exchange.first(), own_layers = exchange.end() - first;
  const int bands = useful_bands(layers.problem().discretisation, exchange, threads);
  throttle_ = ThreadThrottle(std::min(bands, omp_get_num_procs()));
  for (int band = 0; band < bands; ++band) {
    bands_.emplace_back(first + own_layers * band / bands, first + own_layers * (band + 1) / bands,
                        layers.nodes().layer_size());
  }
}

template <int dim>
std::size_t BandSchedule<dim>::bytes() const noexcept {
  const auto force_layers = 5 * bands_.size() + 2;
  return force_layers * dim * layers_->nodes().layer_size() * sizeof(double) + sums_.bytes();
}

template <int dim>
void BandSchedule<dim>::take_steps(std::int64_t first, int steps, Averages<dim>* averages) {
  for (int done = 0; done < steps;) {
    const int taken = take_batch(first + done, steps - done, averages + done);
    throttle_.adjust(taken);
    done += taken;
  }
}

/// Takes a batch of steps and returns their number. A batch has as many steps as fit into a short time, in whole groups
/// for which sums are kept. After it the number of threads may change.
template <int dim>
int BandSchedule<dim>::take_batch(std::int64_t first, int most_steps, Averages<dim>* averages) {
  constexpr double longest = 0.015;  // [s]
  for (auto& band : bands_) {
    band.swept.reset();
    band.moved.reset();
  }
  exchanged_.reset();
  averaged_.reset();
  // Only the first thread changes this number, while the other threads wait for the averages of a group.
  int steps = most_steps;
#pragma omp parallel num_threads(throttle_.threads())
  {
    const ThreadWatch watch;
    const auto threads = static_cast<std::size_t>(omp_get_num_threads());
    const auto thread = static_cast<std::size_t>(omp_get_thread_num());
    // A thread that has several bands has neighbouring ones.
    const auto begin = bands_.size() * thread / threads, end = bands_.size() * (thread + 1) / threads;
    for (int done = 0; done < steps;) {
      const int group = std::min(sums_.steps(), most_steps - done);
      for (int i = 0; i < group; ++i, ++done) take_step(begin, end, first + done, done);
      if (thread == 0) {
        find_averages(first + done - group, done, group, averages + done - group);
        if (watch.wall() > longest) steps = done;
        averaged_.set(done);
      }
      averaged_.wait_for(done);
    }
    throttle_.record(thread, watch.time());
  }
  return steps;
}

/// Takes some bands, those of a thread, through a step; `done` steps of the batch are finished.
template <int dim>
void BandSchedule<dim>::take_step(std::size_t first_band, std::size_t end_band, std::int64_t step, int done) {
  for (auto band = first_band; band < end_band; ++band) sweep(band, step, done);
  if (first_band == 0 && exchange_->has_neighbours()) exchange_forces(done);
  for (auto band = first_band; band < end_band; ++band) move_lowest_layer(band, step, done);
  if (end_band == bands_.size()) move_highest_layer(step, done);
}

template <int dim>
void BandSchedule<dim>::sweep(std::size_t number, std::int64_t step, int done) {
  auto& band = bands_[number];
  const auto& above = bands_[(number + 1) % bands_.size()];
  band.sweep(
      *layers_, sums_, done % sums_.steps(), step,
      [&] {
        if (number == 0 && exchange_->has_neighbours()) exchange_->begin(band.lowest_forces());
      },
      // The band above moves these nodes in the step before, by forces of this band, too.
      [&] { above.moved.wait_for(done); });
  band.swept.set(done + 1);
}

/// Gets the forces on the outermost layers of nodes from the neighbouring processes, or from the opposite end of a
/// periodic box.
template <int dim>
void BandSchedule<dim>::exchange_forces(int done) {
  auto& highest = bands_.back();
  highest.swept.wait_for(done + 1);
  exchange_->finish(highest.highest_forces(), from_below_.view(), from_above_.view());
  exchanged_.set(done + 1);
}

template <int dim>
void BandSchedule<dim>::move_lowest_layer(std::size_t number, std::int64_t step, int done) {
  auto& band = bands_[number];
  if (number > 0) bands_[number - 1].swept.wait_for(done + 1);
  const auto from_below = number > 0 ? bands_[number - 1].highest_forces() : from_below_.view();
  layers_->move_nodes(band.first(), from_below, band.lowest_forces(), step);
  const bool has_whole_box =
      exchange_->first() == 0 && exchange_->end() == layers_->problem().discretisation.grid().cells.back();
  if (number == 0 && wraps() && has_whole_box) layers_->copy_lowest_layer(step);
  if (number + 1 < bands_.size()) band.moved.set(done + 1);
}

/// Moves the layer of nodes above the layers of cells of this process.
template <int dim>
void BandSchedule<dim>::move_highest_layer(std::int64_t step, int done) {
  auto& band = bands_.back();
  const bool is_image = wraps() && band.end() == layers_->problem().discretisation.grid().cells.back();
  if (exchange_->has_neighbours()) exchanged_.wait_for(done + 1);
  if (!is_image) {
    layers_->move_nodes(band.end(), band.highest_forces(), from_above_.view(), step);
  } else if (exchange_->first() > 0) {
    // The lowest layer of the box belongs to another process. This process moves it, too, because it holds the image of
    // the layer.
    layers_->move_nodes(0, band.highest_forces(), from_above_.view(), step);
    layers_->copy_lowest_layer(step);
  }
  band.moved.set(done + 1);
}

/// Computes the averages of the last steps of a batch of which `done` are finished, once all threads have finished
/// them.
template <int dim>
void BandSchedule<dim>::find_averages(std::int64_t first, int done, int steps, Averages<dim>* averages) {
  for (const auto& band : bands_) band.moved.wait_for(done);
  exchange_->gather_node_layers(sums_.numbers());
  for (int i = 0; i < steps; ++i) averages[i] = averages_of(layers_->problem(), sums_, i, first + i);
}

template class BandSchedule<2>;
template class BandSchedule<3>;

}  // namespace breccia::dynamics
