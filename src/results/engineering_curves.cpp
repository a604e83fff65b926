#include "results/engineering_curves.hpp"

#include <algorithm>
#include <cstddef>

#include "homogenisation/complex_moduli.hpp"
#include "homogenisation/tests_of_solid.hpp"
#include "results/best_tests.hpp"
#include "virtual_test/bulk_test.hpp"
#include "viscoelasticity/engineering_moduli.hpp"

namespace breccia {
namespace {

/// The tests in shear and in bulk of a stage under one boundary condition.
struct TestPair {
  const TestResult* shear;
  const TestResult* bulk;
};

/// The pairs for each boundary condition, with the main shear (main_shear).
std::vector<TestPair> pairs_of(const StageFindings& stage) {
  const auto best = best_tests(stage);
  std::vector<TestPair> pairs;
  for (const auto* bulk : best) {
    if (!bulk->id.load.is_bulk()) continue;
    std::vector<const TestResult*> shears;
    std::vector<TestLoad> loads;
    for (const auto* test : best) {
      if (test->id.load.is_bulk() || !are_of_one_solid(*test, *bulk)) continue;
      shears.push_back(test);
      loads.push_back(test->id.load);
    }
    const auto main = main_shear(loads);
    if (!main) continue;
    const auto is_main = [&main](const TestResult* shear) { return shear->id.load == *main; };
    pairs.push_back({*std::ranges::find_if(shears, is_main), bulk});
  }
  return pairs;
}

EngineeringCurves curves_of(const TestPair& pair, int dimensions, const FrequencyRows& rows) {
  const auto& shear = pair.shear->series;
  const auto bulk = bulk_modulus_of(pair.bulk->series, shear, dimensions);
  EngineeringCurves curves{pair.shear->id, {}, {}, shear, bulk};
  for (std::size_t i = 0; i < pair.shear->modulus.size(); ++i) {
    auto& sample = curves.in_time.emplace_back(curves.at_time(pair.shear->modulus[i].time));
    sample.errors = engineering_errors(*pair.shear, *pair.bulk, i, dimensions);
  }
  for (const double frequency : rows.of(pair.shear->modulus)) curves.add_frequency(frequency);
  return curves;
}

}  // namespace

void EngineeringCurves::add_frequency(double angular_frequency) {
  auto sample = at(angular_frequency);
  if (!in_time.empty()) sample.errors = in_time[nearest_sample(in_time, 1.0 / angular_frequency)].errors;
  in_frequency.push_back(sample);
}

EngineeringSample EngineeringCurves::at_time(double time) const {
  const EngineeringModuli moduli(shear, bulk);
  return {time,
          shear.at(time),
          bulk.at(time),
          moduli.youngs_modulus(time),
          moduli.poisson_ratio(time),
          moduli.tensile_compliance(time),
          {}};
}

ComplexEngineeringSample EngineeringCurves::at(double angular_frequency) const {
  const EngineeringModuli moduli(shear, bulk);
  return {angular_frequency,
          shear.complex_modulus(angular_frequency),
          bulk.complex_modulus(angular_frequency),
          moduli.complex_youngs_modulus(angular_frequency),
          moduli.complex_poisson_ratio(angular_frequency),
          {}};
}

std::vector<EngineeringCurves> engineering_curves(const StageFindings& stage, const FrequencyRows& rows) {
  std::vector<EngineeringCurves> all;
  for (const auto& pair : pairs_of(stage)) all.push_back(curves_of(pair, stage.dimensions, rows));
  return all;
}

}  // namespace breccia
