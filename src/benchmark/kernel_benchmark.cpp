#include "benchmark/kernel_benchmark.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <utility>

#include "breccia/error.hpp"

#include "benchmark/model_problem.hpp"
#include "benchmark/stop_watch.hpp"
#include "parallel/reduction.hpp"
#include "parallel/session.hpp"

namespace breccia {
namespace {

double median_of(std::vector<double> values) {
  std::ranges::sort(values);
  const auto middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

/// A dynamic run in 2 or 3 dimensions.
class Steps {
 public:
  virtual ~Steps() = default;
  Steps() = default;
  Steps(const Steps&) = delete;
  Steps& operator=(const Steps&) = delete;
  Steps(Steps&&) = delete;
  Steps& operator=(Steps&&) = delete;

  [[nodiscard]] virtual double points() const = 0;
  [[nodiscard]] virtual Footprint footprint() const = 0;
  virtual void take(int steps) = 0;
};

template <int dim>
class ModelSteps final : public Steps {
 public:
  explicit ModelSteps(const KernelCase& kernel) {
    auto problem = benchmark::model_problem<dim>(kernel.cells, kernel.terms, kernel.mixing);
    points_ = static_cast<double>(problem.discretisation.points());
    solver_ = make_dynamic_solver(kernel.formulation, std::move(problem), kernel.threads, kernel.instructions);
  }

  [[nodiscard]] double points() const override { return points_; }
  [[nodiscard]] Footprint footprint() const override { return solver_->footprint(); }
  void take(int steps) override {
    averages_.clear();
    solver_->advance(steps, averages_);
  }

 private:
  double points_ = 0.0;
  std::unique_ptr<DynamicSolver<dim>> solver_;
  std::vector<Averages<dim>> averages_;
};

std::unique_ptr<Steps> model_steps(const KernelCase& kernel) {
  if (kernel.dimensions == 3) return std::make_unique<ModelSteps<3>>(kernel);
  return std::make_unique<ModelSteps<2>>(kernel);
}

/// A dynamic run that continues from round to round.
class KernelRun {
 public:
  KernelRun(const KernelCase& kernel, Clock clock) : clock_(clock), run_(model_steps(kernel)) {
    timing_.kernel = kernel;
    timing_.points = run_->points();
    const auto footprint = run_->footprint();
    timing_.bytes_per_point = parallel::sum(static_cast<double>(footprint.held)) / timing_.points;
    timing_.bytes_per_point_and_step = parallel::sum(static_cast<double>(footprint.moved_per_step)) / timing_.points;
  }

  /// Finds the number of steps that take about `seconds`, equal on all processes, which step together.
  void calibrate(double seconds) {
    advance();  // the first step is slower, as it touches memory for the first time
    constexpr double enough = 0.1;
    double taken = advance();
    while (taken < enough * seconds) {
      steps_ *= 2;
      taken = advance();
    }
    steps_ = std::max(1, static_cast<int>(std::lround(steps_ * seconds / taken)));
  }

  void take_round() {
    const double points_x_steps = timing_.points * steps_;
    timing_.speeds.push_back(points_x_steps / advance());
  }

  [[nodiscard]] const KernelTiming& timing() const noexcept { return timing_; }

 private:
  /// Time of the work on the slowest process [s].
  double advance() {
    const benchmark::StopWatch watch(clock_, timing_.kernel.threads);
    run_->take(steps_);
    return parallel::largest(watch.seconds());
  }

  Clock clock_;
  KernelTiming timing_;
  std::unique_ptr<Steps> run_;
  int steps_ = 1;
};

/// Measures the memory bandwidth in each round.
class BandwidthRun {
 public:
  explicit BandwidthRun(int threads) : streams_(threads) { timing_.threads = threads; }

  void take_round(double seconds, Clock clock) { timing_.rounds.push_back(streams_.measure(seconds, clock)); }
  [[nodiscard]] const BandwidthTiming& timing() const noexcept { return timing_; }

 private:
  BandwidthTiming timing_;
  MemoryStreams streams_;
};

void require_complete(const BenchmarkPlan& plan) {
  if (plan.cases.empty()) throw InputError("benchmark: there are no cases");
  const auto is_flat_or_cubic = [](const KernelCase& one) { return one.dimensions == 2 || one.dimensions == 3; };
  if (!std::ranges::all_of(plan.cases, is_flat_or_cubic)) throw InputError("benchmark: expected 2 or 3 dimensions");
  const auto is_without_thread = [](const KernelCase& one) { return one.threads < 1; };
  if (std::ranges::any_of(plan.cases, is_without_thread)) throw InputError("benchmark: expected at least one thread");
  if (plan.rounds < 1 || !(plan.seconds > 0.0))
    throw InputError("benchmark: expected at least one round and some time");
}

}  // namespace

double KernelTiming::speed() const {
  return median_of(speeds);
}

double KernelTiming::bandwidth() const {
  return speed() * bytes_per_point_and_step;
}

MemoryBandwidth BandwidthTiming::median() const {
  std::vector<double> triads, updates;
  for (const auto& [triad, update] : rounds) {
    triads.push_back(triad);
    updates.push_back(update);
  }
  return {median_of(std::move(triads)), median_of(std::move(updates))};
}

double BandwidthTiming::highest() const {
  const auto [triad, update] = median();
  return std::max(triad, update);
}

double BenchmarkResult::bandwidth_share(const KernelTiming& kernel) const {
  const auto of_memory = std::ranges::find(bandwidths, kernel.kernel.threads, &BandwidthTiming::threads);
  return kernel.bandwidth() / of_memory->highest();
}

BenchmarkResult run_benchmark(const BenchmarkPlan& plan, const BenchmarkWatch& watch) {
  require_complete(plan);
  std::set<int> threads;
  for (const auto& kernel : plan.cases) threads.insert(kernel.threads);
  std::vector<KernelRun> kernels;
  kernels.reserve(plan.cases.size());
  for (const auto& kernel : plan.cases) kernels.emplace_back(kernel, plan.clock);
  std::vector<BandwidthRun> bandwidths(threads.begin(), threads.end());

  const double turns = static_cast<double>(kernels.size() + bandwidths.size()) * (plan.rounds + 1);
  const double seconds = plan.seconds / turns;
  double done = 0.0;
  const auto report = [&] {
    if (watch) watch(++done / turns);
  };
  for (auto& kernel : kernels) {
    kernel.calibrate(seconds);
    report();
  }
  done = turns / (plan.rounds + 1);
  for (int round = 0; round < plan.rounds; ++round) {
    for (auto& memory : bandwidths) {
      memory.take_round(seconds, plan.clock);
      report();
    }
    for (auto& kernel : kernels) {
      kernel.take_round();
      report();
    }
  }

  BenchmarkResult result;
  result.processes = parallel::ranks();
  result.clock = plan.clock;
  result.machine = this_machine();
  for (const auto& kernel : kernels) result.kernels.push_back(kernel.timing());
  for (const auto& memory : bandwidths) result.bandwidths.push_back(memory.timing());
  return result;
}

}  // namespace breccia
