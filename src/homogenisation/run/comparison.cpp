#include "homogenisation/run/comparison.hpp"

#include <algorithm>
#include <utility>

namespace breccia {
namespace {

bool is_under(const TestResult& test, TestLoad load, Boundary boundary) {
  return test.id.load == load && test.id.boundary == boundary;
}

/// Whether no other method or grid is preferred under the load and the boundary of a test.
bool is_best(const TestResult& test, const std::vector<TestResult>& tests) {
  return std::ranges::none_of(tests, [&](const TestResult& other) {
    return is_under(other, test.id.load, test.id.boundary) && is_preferred(other.id, test.id);
  });
}

std::vector<ComparedSample> compared_in_time(const Measurement& measurement, const Curve& curve) {
  std::vector<ComparedSample> samples;
  const auto known = measurement.known_within({curve.front().time, curve.back().time});
  if (!known) return samples;
  for (const auto& [time, modulus] : curve) {
    if (time < known->begin || time > known->end) continue;
    samples.push_back({time, modulus, measurement.at(time)});
  }
  return samples;
}

std::vector<ComparedComplexSample> compared_in_frequency(const Measurement& measurement, const TestResult& test) {
  std::vector<ComparedComplexSample> samples;
  if (!(test.series.unrelaxed() > 0.0)) return samples;
  std::vector<double> frequencies;
  for (const auto& sample : test.in_frequency) frequencies.push_back(sample.angular_frequency);
  const TimeWindow window = {test.modulus.front().time, test.modulus.back().time};
  for (const auto& [omega, storage, loss] : measurement.complex_within(window, frequencies)) {
    const auto modulus = test.series.complex_modulus(omega);
    samples.push_back({omega, modulus.real(), modulus.imag(), storage, loss});
  }
  return samples;
}

}  // namespace

std::vector<Comparison> compare(const std::vector<Measurement>& measurements, const std::string& stage, TestLoad shear,
                                const std::vector<TestResult>& tests) {
  std::vector<Comparison> comparisons;
  for (const auto& measurement : measurements) {
    if (measurement.stage != stage) continue;
    for (const auto& test : tests) {
      if (!is_under(test, shear, test.id.boundary)) continue;
      if (find_preferred_test(tests, shear, test.id.boundary, test.id.method) != &test) continue;
      Comparison comparison{measurement.label, test.id, compared_in_time(measurement, test.modulus)};
      if (is_best(test, tests)) comparison.in_frequency = compared_in_frequency(measurement, test);
      if (comparison.samples.empty() && comparison.in_frequency.empty()) continue;
      comparisons.push_back(std::move(comparison));
    }
  }
  return comparisons;
}

std::vector<Measurement> measurements_of(const std::string& stage, const std::vector<Comparison>& comparisons) {
  std::vector<Measurement> measurements;
  for (const auto& comparison : comparisons) {
    auto known = std::ranges::find(measurements, comparison.measurement, &Measurement::label);
    if (known == measurements.end()) {
      known = measurements.insert(known, Measurement{comparison.measurement, stage, Curve{}});
    }
    auto& curve = std::get<Curve>(known->shear);
    if (curve.empty()) {
      for (const auto& sample : comparison.samples) curve.push_back({sample.time, sample.measured});
    }
    if (known->dynamic.empty()) {
      for (const auto& sample : comparison.in_frequency) {
        known->dynamic.push_back({sample.angular_frequency, sample.measured_storage, sample.measured_loss});
      }
    }
  }
  std::erase_if(measurements, [](const Measurement& one) { return std::get<Curve>(one.shear).size() < 2; });
  return measurements;
}

}  // namespace breccia
