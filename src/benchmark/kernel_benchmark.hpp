#pragma once

#include <functional>
#include <vector>

#include "benchmark/clock.hpp"
#include "benchmark/machine.hpp"
#include "benchmark/memory_bandwidth.hpp"
#include "dynamics/dynamic_solver.hpp"

namespace breccia {

/// A kernel and the conditions under which its steps are timed.
struct KernelCase {
  Formulation formulation = Formulation::total_lagrangian;
  InstructionSet instructions = InstructionSet::baseline;  ///< instruction set of the total Lagrangian formulation
  int cells = 0;                                           ///< cells per side, with 2^dimensions material points each
  int terms = 0;                                           ///< Prony terms of the matrix's shear modulus; 0: elastic
  int threads = 1;                                         ///< threads of each process, at least one
  Mixing mixing = Mixing::series;                          ///< treatment of the cells that an interface crosses
  int dimensions = 2;                                      ///< 2 or 3
};

/// The measurements of a benchmark.
struct BenchmarkPlan {
  std::vector<KernelCase> cases;
  double seconds = 10.0;  ///< approximate time of all measurements together [s]
  int rounds = 7;         ///< each round measures every case and every bandwidth once
  Clock clock = Clock::wall;
};

/// Measured speeds of one case, summed over all processes.
struct KernelTiming {
  KernelCase kernel;
  double points = 0.0;
  double bytes_per_point = 0.0;           ///< size of the arrays [B]
  double bytes_per_point_and_step = 0.0;  ///< Footprint::moved_per_step [B]
  std::vector<double> speeds;             ///< material points x steps per second in each round [1/s]

  [[nodiscard]] double bytes() const { return points * bytes_per_point; }
  [[nodiscard]] double speed() const;      ///< median [1/s]
  [[nodiscard]] double bandwidth() const;  ///< memory traffic at the median speed [B/s]
};

/// Measured memory bandwidths, summed over all processes.
struct BandwidthTiming {
  int threads = 1;                      ///< threads of each process
  std::vector<MemoryBandwidth> rounds;  ///< one for each round

  [[nodiscard]] MemoryBandwidth median() const;
  /// The higher of the two medians [B/s].
  [[nodiscard]] double highest() const;
};

/// All results of a benchmark.
struct BenchmarkResult {
  int processes = 1;
  Clock clock = Clock::wall;
  Machine machine = {};
  std::vector<KernelTiming> kernels;        ///< one for each case
  std::vector<BandwidthTiming> bandwidths;  ///< one for each number of threads among the cases, rising

  /// Ratio of the memory traffic of a kernel to the highest bandwidth measured with as many threads [-]. It can exceed
  /// 1 if the arrays fit into the caches.
  [[nodiscard]] double bandwidth_share(const KernelTiming& kernel) const;
};

/// A function that is called with the finished share of the work, 0 to 1. An exception that it throws ends the work.
using BenchmarkWatch = std::function<void(double)>;

/// Times the steps of each case on a random packing of discs, which fill 65 % of the box, or of spheres, which fill 40
/// %, in a relaxing matrix. The cases are measured in turn in each round, so that a slower machine slows all of them; a
/// case takes at least one step per round. Throws InputError when there are no cases or no rounds.
BenchmarkResult run_benchmark(const BenchmarkPlan& plan, const BenchmarkWatch& watch = {});

}  // namespace breccia
