#include "homogenisation/run/comparison.hpp"

#include <algorithm>
#include <complex>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>

#include "homogenisation/complex_moduli.hpp"
#include "homogenisation/engineering_errors.hpp"
#include "homogenisation/tests_of_solid.hpp"
#include "virtual_test/bulk_test.hpp"
#include "viscoelasticity/engineering_moduli.hpp"

namespace breccia {
namespace {

/// A modulus of a stage under one boundary and by one method.
struct ComputedModulus {
  Curve in_time;
  std::vector<std::optional<double>> errors;  ///< whole errors at these times [-]; empty where none is known
  /// The complex modulus [Pa] at an angular frequency [rad/s]; empty where there is none.
  std::function<std::complex<double>(double)> at;

  /// The error at the nearest time to a time [s].
  [[nodiscard]] std::optional<double> error_at(double time) const {
    return errors.size() == in_time.size() ? errors[nearest_sample(in_time, time)] : std::nullopt;
  }
};

bool is_under(const TestResult& test, TestLoad load, Boundary boundary) {
  return test.id.load == load && test.id.boundary == boundary;
}

/// Whether no other method or grid is preferred under the load and the boundary of a test.
bool is_best(const TestResult& test, const std::vector<TestResult>& tests) {
  return std::ranges::none_of(tests, [&](const TestResult& other) {
    return is_under(other, test.id.load, test.id.boundary) && is_preferred(other.id, test.id);
  });
}

/// The load of the tests of which a measured modulus is: bulk for K in three dimensions, where it is what is tested.
TestLoad load_of(ModulusKind kind, int dimensions, TestLoad shear) {
  return kind == ModulusKind::bulk && !is_plane_strain(dimensions) ? TestLoad(Load::bulk) : shear;
}

/// The modulus of a test itself.
ComputedModulus tested_modulus(const TestResult& test) {
  ComputedModulus modulus{test.modulus, {}, {}};
  for (const auto& error : test.errors) modulus.errors.push_back(error.whole());
  if (test.series.unrelaxed() > 0.0) {
    modulus.at = [&test](double omega) { return test.series.complex_modulus(omega); };
  }
  return modulus;
}

/// E, or K in the plane, from a test in shear and the one in bulk beside it; nothing without this test.
std::optional<ComputedModulus> modulus_of_both(ModulusKind kind, const StageFindings& stage, const TestResult& shear) {
  const auto* tested = find_preferred_test(stage.tests, Load::bulk, shear.id.boundary, shear.id.method);
  if (tested == nullptr || !are_of_one_solid(shear, *tested)) return std::nullopt;
  const auto bulk = bulk_modulus_of(tested->series, shear.series, stage.dimensions);
  ComputedModulus modulus;
  for (std::size_t i = 0; i < shear.modulus.size(); ++i) {
    const auto errors = engineering_errors(shear, *tested, i, stage.dimensions);
    modulus.errors.push_back(kind == ModulusKind::bulk ? errors.bulk : errors.young);
  }
  if (kind == ModulusKind::bulk) {
    for (const auto& [time, of_shear] : shear.modulus) modulus.in_time.push_back({time, bulk.at(time)});
    modulus.at = [bulk](double omega) { return bulk.complex_modulus(omega); };
    return modulus;
  }
  const EngineeringModuli moduli(shear.series, bulk);
  for (const auto& [time, of_shear] : shear.modulus) modulus.in_time.push_back({time, moduli.youngs_modulus(time)});
  modulus.at = [moduli](double omega) { return moduli.complex_youngs_modulus(omega); };
  return modulus;
}

/// The modulus of a kind from a test under its load (load_of); nothing where that takes another test that is missing.
std::optional<ComputedModulus> computed_modulus(ModulusKind kind, const StageFindings& stage, const TestResult& test) {
  const bool is_tested = kind == ModulusKind::shear || test.id.load.is_bulk();
  return is_tested ? tested_modulus(test) : modulus_of_both(kind, stage, test);
}

std::vector<ComparedSample> compared_in_time(const Measurement& measurement, const ComputedModulus& computed) {
  const auto& curve = computed.in_time;
  std::vector<ComparedSample> samples;
  const auto known = measurement.known_within({curve.front().time, curve.back().time});
  if (!known) return samples;
  for (const auto& [time, modulus] : curve) {
    if (time < known->begin || time > known->end) continue;
    samples.push_back({time, modulus, measurement.at(time), computed.error_at(time)});
  }
  return samples;
}

std::vector<ComparedComplexSample> compared_in_frequency(const Measurement& measurement, const ComputedModulus& modulus,
                                                         const std::vector<ComplexSample>& of_study) {
  std::vector<ComparedComplexSample> samples;
  if (!modulus.at) return samples;
  std::vector<double> frequencies;
  frequencies.reserve(of_study.size());
  for (const auto& sample : of_study) frequencies.push_back(sample.angular_frequency);
  const TimeWindow window = {modulus.in_time.front().time, modulus.in_time.back().time};
  for (const auto& [omega, storage, loss] : measurement.complex_within(window, frequencies)) {
    const auto there = modulus.at(omega);
    samples.push_back({omega, there.real(), there.imag(), storage, loss, modulus.error_at(1.0 / omega)});
  }
  return samples;
}

}  // namespace

std::vector<Comparison> compare(const std::vector<Measurement>& measurements, const StageFindings& stage,
                                TestLoad shear) {
  const auto& tests = stage.tests;
  std::vector<Comparison> comparisons;
  for (const auto& measurement : measurements) {
    if (measurement.stage != stage.name) continue;
    const auto load = load_of(measurement.kind, stage.dimensions, shear);
    for (const auto& test : tests) {
      if (!is_under(test, load, test.id.boundary)) continue;
      if (find_preferred_test(tests, load, test.id.boundary, test.id.method) != &test) continue;
      const auto modulus = computed_modulus(measurement.kind, stage, test);
      if (!modulus) continue;
      Comparison comparison{measurement.label, test.id, compared_in_time(measurement, *modulus)};
      comparison.kind = measurement.kind;
      if (is_best(test, tests)) {
        comparison.in_frequency = compared_in_frequency(measurement, *modulus, test.in_frequency);
      }
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
      known->kind = comparison.kind;
    }
    auto& curve = std::get<Curve>(known->modulus);
    if (curve.empty()) {
      for (const auto& sample : comparison.samples) curve.push_back({sample.time, sample.measured});
    }
    if (known->dynamic.empty()) {
      for (const auto& sample : comparison.in_frequency) {
        known->dynamic.push_back({sample.angular_frequency, sample.measured_storage, sample.measured_loss});
      }
    }
  }
  std::erase_if(measurements, [](const Measurement& one) { return std::get<Curve>(one.modulus).size() < 2; });
  return measurements;
}

}  // namespace breccia
