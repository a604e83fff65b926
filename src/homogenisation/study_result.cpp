#include "breccia/homogenisation/study_result.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia {
namespace {

/// The distance of the ratio of a sample from one, on a logarithmic scale.
constexpr auto distance_from_one = [](const auto& sample) { return std::abs(std::log(sample.ratio())); };

/// The sample whose ratio is nearest to one; nullptr without samples.
template <class Sample>
const Sample* nearest(const std::vector<Sample>& samples) {
  const auto found = std::ranges::min_element(samples, {}, distance_from_one);
  return found == samples.end() ? nullptr : &*found;
}

/// The sample whose ratio is furthest from one; nullptr without samples.
template <class Sample>
const Sample* furthest(const std::vector<Sample>& samples) {
  const auto found = std::ranges::max_element(samples, {}, distance_from_one);
  return found == samples.end() ? nullptr : &*found;
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

double ComparedComplexSample::ratio() const {
  return std::hypot(storage, loss) / std::hypot(measured_storage, measured_loss);
}

double ComparedComplexSample::phase_difference() const {
  return std::atan2(loss, storage) - std::atan2(measured_loss, measured_storage);
}

const ComparedSample* Comparison::best() const {
  return nearest(samples);
}

const ComparedSample* Comparison::worst() const {
  return furthest(samples);
}

const ComparedComplexSample* Comparison::best_in_frequency() const {
  return nearest(in_frequency);
}

const ComparedComplexSample* Comparison::worst_in_frequency() const {
  return furthest(in_frequency);
}

}  // namespace breccia
