#include "breccia/homogenisation/study_result.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia {
namespace {

double distance_from_one(const ComparedSample& sample) {
  return std::abs(std::log(sample.ratio()));
}

}  // namespace

std::optional<double> ModulusError::whole() const {
  double squares = 0.0;
  for (const auto& cause : {grid, sample, solver, matrix}) {
    if (!cause) return std::nullopt;
    squares += *cause * *cause;
  }
  return std::sqrt(squares);
}

std::optional<double> largest_whole(const std::vector<ModulusError>& errors) {
  std::optional<double> largest;
  for (const auto& error : errors) {
    const auto whole = error.whole();
    if (!whole) return std::nullopt;
    largest = std::max(largest.value_or(0.0), *whole);
  }
  return largest;
}

const TestResult* find_preferred_test(const std::vector<TestResult>& tests, TestLoad load, Boundary boundary,
                                      Method method) {
  const TestResult* best = nullptr;
  for (const auto& test : tests) {
    const auto& id = test.id;
    if (id.load != load || id.boundary != boundary || id.method != method) continue;
    if (best == nullptr || is_preferred(id, best->id)) best = &test;
  }
  return best;
}

const TestResult& preferred_test(const std::vector<TestResult>& tests, TestLoad load, Boundary boundary,
                                 Method method) {
  const auto* best = find_preferred_test(tests, load, boundary, method);
  if (best != nullptr) return *best;
  throw InputError(fmt::format("no test under {} with the {} boundary by the {} method", name_of(load),
                               name_of(boundary), name_of(method)));
}

const ComparedSample& Comparison::best() const {
  return *std::ranges::min_element(samples, {}, distance_from_one);
}

const ComparedSample& Comparison::worst() const {
  return *std::ranges::max_element(samples, {}, distance_from_one);
}

}  // namespace breccia
