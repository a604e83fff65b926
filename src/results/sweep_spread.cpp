#include "results/sweep_spread.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace breccia {

namespace {

/// The moduli of one test in several tasks, by time.
using Samples = std::map<double, std::vector<double>>;

struct TestSamples {
  std::size_t first_task;
  TaskCurve test;
  Samples samples;
};

SeedSpread spread_of(double time, const std::vector<double>& moduli) {
  const auto count = static_cast<double>(moduli.size());
  const auto [smallest, largest] = std::ranges::minmax(moduli);
  double sum = 0.0;
  for (const double modulus : moduli) sum += modulus;
  const double mean = sum / count;
  double squares = 0.0;
  for (const double modulus : moduli) squares += (modulus - mean) * (modulus - mean);
  return {time, moduli.size(), mean, std::sqrt(squares / (count - 1.0)), smallest, largest};
}

}  // namespace

bool differ_only_in(const Sweep& sweep, const SweepTask& one, const SweepTask& other,
                    const std::function<bool(const SweptKey&)>& keys) {
  for (std::size_t key = 0; key < sweep.keys.size(); ++key) {
    if (!keys(sweep.keys[key]) && one.values[key] != other.values[key]) return false;
  }
  return true;
}

std::vector<SpreadCurve> spread_over_seeds(const Sweep& sweep, const SweepResult& result) {
  std::vector<TestSamples> tests;
  if (std::ranges::none_of(sweep.keys, &SweptKey::is_seed)) return {};
  for (std::size_t task = 0; task < result.size(); ++task) {
    for (const auto& curve : result[task].curves) {
      auto test = std::ranges::find_if(tests, [&](const TestSamples& known) {
        return known.test.matches(curve) &&
               differ_only_in(sweep, sweep.tasks[known.first_task], sweep.tasks[task], &SweptKey::is_seed);
      });
      if (test == tests.end()) {
        auto unsampled = curve;
        unsampled.modulus.clear();
        test = tests.insert(tests.end(), {task, std::move(unsampled), {}});
      }
      for (const auto& [time, modulus] : curve.modulus) test->samples[time].push_back(modulus);
    }
  }
  std::vector<SpreadCurve> curves;
  for (auto& [task, test, samples] : tests) {
    SpreadCurve curve{task, std::move(test), {}};
    for (const auto& [time, moduli] : samples) {
      if (moduli.size() > 1) curve.spreads.push_back(spread_of(time, moduli));
    }
    if (!curve.spreads.empty()) curves.push_back(std::move(curve));
  }
  return curves;
}

std::string name_without_seeds(const Sweep& sweep, const SweepTask& task) {
  std::vector<std::string> labels;
  for (std::size_t key = 0; key < sweep.keys.size(); ++key) {
    if (!sweep.keys[key].is_seed) labels.push_back(task.labels[key]);
  }
  return fmt::format("{}", fmt::join(labels, "_"));
}

}  // namespace breccia
