// Material points x steps per second of the explicit formulations, on one thread, for a random packing of discs whose
// matrix has a number of active Maxwell terms. Run with --benchmark_repetitions=5
// --benchmark_enable_random_interleaving=true and compare medians.

#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "breccia/dynamics/dynamic_solver.hpp"
#include "breccia/microstructure/packing.hpp"

namespace breccia {
namespace {

/// 200 equal discs that fill 65 % of a box of 1 m.
const Microstructure& packed_box() {
  static const Microstructure box = [] {
    constexpr int discs = 200;
    PackingRequest request;
    request.side = 1.0;
    request.diameters.assign(discs, std::sqrt(0.65 * 4.0 / (std::numbers::pi * discs)));
    request.minimum_gap = 0.005;
    return Microstructure{1.0, Walls::hard, pack<2>(request).balls};
  }();
  return box;
}

DynamicProblem problem_with(int cells, int terms) {
  std::vector<MaxwellTerm> spectrum;
  spectrum.reserve(static_cast<std::size_t>(terms));
  for (int k = 0; k < terms; ++k) spectrum.push_back({1e-3 * std::pow(10.0, k), 1e8});
  DynamicProblem problem{discretise(packed_box(), cells),
                         {{"binder", 1480.0, PronySeries(3.6e9), PronySeries(1e7, spectrum)},
                          {"filler", 1850.0, PronySeries(13.4e9), PronySeries(5.84e9)}}};
  problem.load = {.xy = 0.5};
  problem.ramp = StrainRamp(1e-3);
  problem.time_step =
      0.9 * stable_time_step(problem.discretisation, problem.materials, problem.volumetric, problem.density_factor);
  return problem;
}

/// Arguments: cells a side, terms.
template <Formulation formulation>
void steps_on_one_thread(benchmark::State& state) {
  auto problem = problem_with(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  const auto points = static_cast<double>(problem.discretisation.points());
  const auto solver = make_dynamic_solver(formulation, std::move(problem), 1);
  std::vector<Averages> stresses;
  constexpr int steps = 20;
  for (auto _ : state) {
    stresses.clear();
    solver->advance(steps, stresses);
    benchmark::DoNotOptimize(stresses.data());
  }
  state.counters["points_x_steps"] =
      benchmark::Counter(points * steps * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

BENCHMARK(steps_on_one_thread<Formulation::total_lagrangian>)
    ->Name("total_lagrangian")
    ->ArgNames({"cells", "terms"})
    ->ArgsProduct({{158, 500}, {0, 1, 5, 10}})
    ->Unit(benchmark::kMillisecond);
BENCHMARK(steps_on_one_thread<Formulation::classical>)
    ->Name("classical")
    ->ArgNames({"cells", "terms"})
    ->ArgsProduct({{158}, {0, 5}})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace breccia

BENCHMARK_MAIN();
