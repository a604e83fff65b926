#include "homogenisation/complex_moduli.hpp"

#include <numbers>

#include "study/abscissa_words.hpp"

namespace breccia {

std::vector<double> frequencies_in_hertz(const Curve& curve, int per_decade) {
  constexpr double per_cycle = 2.0 * std::numbers::pi;
  auto frequencies = logarithmic_times({hertz_of(curve.back().time), hertz_of(curve.front().time)}, per_decade);
  for (auto& frequency : frequencies) frequency *= per_cycle;
  return frequencies;
}

std::optional<double> whole_error_at(const TestResult& test, double time) {
  return test.errors.empty() ? std::nullopt : test.errors.at(nearest_sample(test.modulus, time)).whole();
}

std::vector<ComplexSample> complex_moduli(const TestResult& test, const std::vector<double>& angular_frequencies) {
  std::vector<ComplexSample> samples;
  if (!(test.series.unrelaxed() > 0.0)) return samples;
  for (const double omega : angular_frequencies) {
    const auto modulus = test.series.complex_modulus(omega);
    samples.push_back({omega, modulus.real(), modulus.imag(), whole_error_at(test, 1.0 / omega)});
  }
  return samples;
}

void add_complex_moduli(std::vector<TestResult>& tests, int per_decade) {
  for (auto& test : tests) {
    if (!test.modulus.empty()) {
      test.in_frequency = complex_moduli(test, frequencies_in_hertz(test.modulus, per_decade));
    }
  }
}

}  // namespace breccia
