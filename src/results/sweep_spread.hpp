#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "breccia/study/sweep.hpp"

#include "results/sweep_result.hpp"

namespace breccia {

/// Statistics over the tasks that differ only in their seeds: the modulus of one test at one time.
struct SeedSpread {
  double time = 0.0;                ///< [s]
  std::size_t tasks = 0;            ///< number of tasks, two or more
  double mean = 0.0;                ///< [Pa]
  double standard_deviation = 0.0;  ///< standard deviation of the sample, with n - 1 in the denominator [Pa]
  double smallest = 0.0;            ///< [Pa]
  double largest = 0.0;             ///< [Pa]
};

/// The spread of one test over the seeds, against time.
struct SpreadCurve {
  std::size_t first_task = 0;  ///< number of the first of these tasks
  TaskCurve test;              ///< stage and test, without a curve
  std::vector<SeedSpread> spreads;
};

/// The spread of every test over the seeds, for each combination of the other keys. Times that only one task has are
/// left out.
std::vector<SpreadCurve> spread_over_seeds(const Sweep& sweep, const SweepResult& result);

/// The name of a task without its seeds; empty if only seeds are swept.
std::string name_without_seeds(const Sweep& sweep, const SweepTask& task);

/// Whether two tasks have the same values of all keys, except those for which the function returns true.
bool differ_only_in(const Sweep& sweep, const SweepTask& one, const SweepTask& other,
                    const std::function<bool(const SweptKey&)>& keys);

}  // namespace breccia
