#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "breccia/study/sweep.hpp"

#include "results/sweep_result.hpp"

namespace breccia {

/// Statistics of one quantity over the tasks that differ only in their seeds, in its unit.
struct SeedSpread {
  std::size_t tasks = 0;  ///< number of tasks, two or more
  double mean = 0.0;
  double standard_deviation = 0.0;  ///< of the sample, with n - 1 in the denominator
  double smallest = 0.0;
  double largest = 0.0;
};

/// The spread of a relaxation modulus at one time.
struct SpreadAtTime {
  double time = 0.0;        ///< [s]
  SeedSpread modulus = {};  ///< [Pa]
};

/// The spread of a complex modulus at one frequency.
struct SpreadAtFrequency {
  double angular_frequency = 0.0;  ///< [rad/s]
  SeedSpread absolute = {};        ///< of its absolute value [Pa]
  SeedSpread phase = {};           ///< [rad]
};

/// The spread of one test over the seeds.
struct SpreadCurve {
  std::size_t first_task = 0;  ///< number of the first of these tasks
  TaskCurve test;              ///< stage and test, without a curve
  std::vector<SpreadAtTime> in_time;
  std::vector<SpreadAtFrequency> in_frequency;  ///< of a study in frequency
};

/// The spread of every test over the seeds, for each combination of the other keys. Times and frequencies that only one
/// task has are left out.
std::vector<SpreadCurve> spread_over_seeds(const Sweep& sweep, const SweepResult& result);

/// The name of a task without its seeds; empty if only seeds are swept.
std::string name_without_seeds(const Sweep& sweep, const SweepTask& task);

/// Whether two tasks have the same values of all keys, except those for which the function returns true.
bool differ_only_in(const Sweep& sweep, const SweepTask& one, const SweepTask& other,
                    const std::function<bool(const SweptKey&)>& keys);

}  // namespace breccia
