#include "homogenisation/largest_errors.hpp"

#include <algorithm>
#include <vector>

#include "homogenisation/box_bounds.hpp"
#include "homogenisation/run/isotropic_mean.hpp"

namespace breccia {
namespace {

/// Whether there is a test under the same load and boundary that is preferred to this one.
bool has_better(const std::vector<TestResult>& tests, const TestResult& test) {
  return std::ranges::any_of(tests, [&](const TestResult& other) {
    return other.id.load == test.id.load && other.id.boundary == test.id.boundary && is_preferred(other.id, test.id);
  });
}

/// The largest of one part of the errors of tests, which `of` returns; nothing where one is not known.
template <class Part>
std::optional<double> largest(const std::vector<const TestResult*>& tests, const Part& of) {
  std::optional<double> largest;
  for (const auto* test : tests) {
    for (const auto& error : test->errors) {
      const std::optional<double> part = of(error);
      if (!part) return std::nullopt;
      largest = std::max(largest.value_or(0.0), *part);
    }
  }
  return largest;
}

/// The largest ratio of the half band of a test to its modulus; nothing for a single grid.
std::optional<double> grid_share_of(const TestResult& test) {
  std::optional<double> largest;
  for (const double time : logarithmic_times({test.modulus.front().time, test.modulus.back().time}, 1)) {
    const auto band = half_band(test, time);
    if (band) largest = std::max(largest.value_or(0.0), *band / smoothed_at(test.modulus, time));
  }
  return largest;
}

}  // namespace

bool answers(const TestId& test, const std::vector<TestResult>& tests) {
  return test.boundary == Boundary::periodic ||
         std::ranges::none_of(tests, [](const TestResult& other) { return other.id.boundary == Boundary::periodic; });
}

LargestErrors largest_errors_of(const StageFindings& stage) {
  std::vector<const TestResult*> preferred;
  LargestErrors errors;
  for (const auto& test : stage.tests) {
    const bool is_answer = answers(test.id, stage.tests);
    if (find_preferred_test(stage.tests, test.id.load, test.id.boundary, test.id.method) == &test) {
      auto& largest = is_answer ? errors.grid : errors.grid_of_others;
      if (const auto share = grid_share_of(test)) largest = std::max(largest.value_or(0.0), *share);
    }
    const bool is_replaced = is_replaced_by_mean(test.id, stage.dimensions, stage.tests);
    if (is_answer && !is_replaced && !has_better(stage.tests, test)) preferred.push_back(&test);
  }
  errors.whole = largest(preferred, [](const ModulusError& error) { return error.whole(); });
  errors.sample = largest(preferred, [](const ModulusError& error) { return error.sample; });
  errors.matrix = largest(preferred, [](const ModulusError& error) { return error.matrix; });
  return errors;
}

}  // namespace breccia
