#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <ranges>
#include <vector>

#include "breccia/homogenisation/study_result.hpp"
#include "breccia/virtual_test/curve.hpp"

namespace breccia {

/// The angular frequencies [rad/s] at 10^(k/n) Hz for whole k, n a decade, and at the first and the last frequency 1/t
/// of the times t of a curve; rising.
std::vector<double> frequencies_in_hertz(const Curve& curve, int per_decade);

/// The index of the sample of a curve in time that is nearest to a time [s], on a logarithmic axis.
template <std::ranges::random_access_range Samples>
std::size_t nearest_sample(const Samples& samples, double time) {
  const auto distance = [time](const auto& sample) { return std::abs(std::log(sample.time / time)); };
  return static_cast<std::size_t>(std::ranges::min_element(samples, {}, distance) - std::ranges::begin(samples));
}

/// The whole error of a test at its time nearest to the given one [s]; nothing where it is not known.
std::optional<double> whole_error_at(const TestResult& test, double time);

/// The complex modulus of the series of a test at angular frequencies [rad/s], with the errors; nothing where the test
/// has no series, as one that was read from a directory beside a preferred one.
std::vector<ComplexSample> complex_moduli(const TestResult& test, const std::vector<double>& angular_frequencies);

/// Gives the tests of a stage, which have their errors already, their complex moduli at the frequencies of a study in
/// hertz.
void add_complex_moduli(std::vector<TestResult>& tests, int per_decade);

}  // namespace breccia
