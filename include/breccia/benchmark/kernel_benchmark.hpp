#pragma once

#include <functional>
#include <vector>

#include "breccia/benchmark/clock.hpp"
#include "breccia/benchmark/machine.hpp"
#include "breccia/benchmark/memory_bandwidth.hpp"
#include "breccia/dynamics/dynamic_solver.hpp"

namespace breccia {

/// A kernel and the conditions under which its steps are timed.
struct KernelCase {
  Formulation formulation = Formulation::total_lagrangian;
  InstructionSet instructions = InstructionSet::baseline;  ///< of the total-lagrangian formulation
  int cells = 0;                                           ///< a side; four material points each
  int terms = 0;                                           ///< of the matrix's shear modulus; 0 where it is elastic
  int threads = 1;                                         ///< of each process
};

struct BenchmarkPlan {
  std::vector<KernelCase> cases;
  double seconds = 10.0;  ///< for all measurements together, about
  int rounds = 7;         ///< in each of them every case and every bandwidth has its turn
  Clock clock = Clock::wall;
};

/// Speeds of one case, of all processes together.
struct KernelTiming {
  KernelCase kernel;
  double points = 0.0;
  double bytes_per_point = 0.0;           ///< of the arrays [B]
  double bytes_per_point_and_step = 0.0;  ///< Footprint::moved_per_step [B]
  std::vector<double> speeds;             ///< material points x steps per second [1/s], of each round

  [[nodiscard]] double bytes() const { return points * bytes_per_point; }
  [[nodiscard]] double speed() const;      ///< median [1/s]
  [[nodiscard]] double bandwidth() const;  ///< that the median speed asks for [B/s]
};

/// Bandwidths of the memory, of all processes together.
struct BandwidthTiming {
  int threads = 1;                      ///< of each process
  std::vector<MemoryBandwidth> rounds;  ///< [B/s]

  [[nodiscard]] MemoryBandwidth median() const;
  /// The higher of the two medians [B/s].
  [[nodiscard]] double highest() const;
};

struct BenchmarkResult {
  int processes = 1;
  Clock clock = Clock::wall;
  Machine machine = {};
  std::vector<KernelTiming> kernels;        ///< by case
  std::vector<BandwidthTiming> bandwidths;  ///< one for each number of threads among the cases, rising

  /// Bandwidth that a kernel asks for over the highest that its threads were measured to get from memory [-]. Not
  /// bounded by one where its arrays fit into the caches.
  [[nodiscard]] double bandwidth_share(const KernelTiming& kernel) const;
};

/// Told the share of the work that is done, 0 to 1. What it throws ends the work.
using BenchmarkWatch = std::function<void(double)>;

/// Times the steps of each case on a random packing of discs, 65 % of a box whose matrix relaxes. Rounds are
/// interleaved, so that a machine that slows down slows down all of them; a round of a case is at least one step.
/// Throws InputError when there are no cases or no rounds.
BenchmarkResult run_benchmark(const BenchmarkPlan& plan, const BenchmarkWatch& watch = {});

}  // namespace breccia
