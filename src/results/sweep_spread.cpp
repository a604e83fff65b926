#include "results/sweep_spread.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace breccia {

namespace {

/// The values of one test in several tasks, by time or by angular frequency.
using Samples = std::map<double, std::vector<double>>;

struct TestSamples {
  std::size_t first_task;
  TaskCurve test;
  Samples moduli, absolutes, phases;

  void add(const TaskCurve& curve) {
    for (const auto& [time, modulus] : curve.modulus) moduli[time].push_back(modulus);
    for (const auto& sample : curve.in_frequency) {
      absolutes[sample.angular_frequency].push_back(std::hypot(sample.storage, sample.loss));
      phases[sample.angular_frequency].push_back(std::atan2(sample.loss, sample.storage));
    }
  }
};

SeedSpread spread_of(const std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  const auto [smallest, largest] = std::ranges::minmax(values);
  double sum = 0.0;
  for (const double value : values) sum += value;
  const double mean = sum / count;
  double squares = 0.0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return {values.size(), mean, std::sqrt(squares / (count - 1.0)), smallest, largest};
}

SpreadCurve spread_of(TestSamples samples) {
  SpreadCurve curve{samples.first_task, std::move(samples.test), {}, {}};
  for (const auto& [time, moduli] : samples.moduli) {
    if (moduli.size() > 1) curve.in_time.push_back({time, spread_of(moduli)});
  }
  for (const auto& [frequency, absolutes] : samples.absolutes) {
    if (absolutes.size() < 2) continue;
    curve.in_frequency.push_back({frequency, spread_of(absolutes), spread_of(samples.phases.at(frequency))});
  }
  return curve;
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
        test = tests.insert(tests.end(), {task, {curve.stage, curve.test, {}}, {}, {}, {}});
      }
      test->add(curve);
    }
  }
  std::vector<SpreadCurve> curves;
  for (auto& samples : tests) {
    auto curve = spread_of(std::move(samples));
    if (!curve.in_time.empty()) curves.push_back(std::move(curve));
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
