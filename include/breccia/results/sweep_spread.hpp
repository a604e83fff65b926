#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "breccia/deck/sweep.hpp"
#include "breccia/results/sweep_result.hpp"

namespace breccia {

/// The moduli of tasks that differ in their seeds alone, at one time of one test.
struct Spread {
  double time = 0.0;                ///< [s]
  std::size_t tasks = 0;            ///< two or more
  double mean = 0.0;                ///< [Pa]
  double standard_deviation = 0.0;  ///< of a sample, with n - 1 [Pa]
  double smallest = 0.0;            ///< [Pa]
  double largest = 0.0;             ///< [Pa]
};

/// The spread of a test over the seeds.
struct SpreadCurve {
  std::size_t first_task = 0;  ///< of those that differ in their seeds alone
  TaskCurve test;              ///< without its curve
  std::vector<Spread> spreads;
};

/// The spread of every test over the seeds, for each combination of the other keys; times that a single task has are
/// left out.
std::vector<SpreadCurve> spread_over_seeds(const Sweep& sweep, const SweepResult& result);

/// The parts of the name of a task that do not tell its seeds; empty when there are no others.
std::string name_without_seeds(const Sweep& sweep, const SweepTask& task);

/// Have two tasks the same values of all keys but those that a function picks?
bool differ_only_in(const Sweep& sweep, const SweepTask& one, const SweepTask& other,
                    const std::function<bool(const SweptKey&)>& keys);

}  // namespace breccia
