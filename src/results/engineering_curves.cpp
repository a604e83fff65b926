#include "results/engineering_curves.hpp"

#include <algorithm>

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

/// The pairs for each boundary condition: with the load `shear`, or else with the first load of shear.
std::vector<TestPair> pairs_of(const StageFindings& stage) {
  const auto best = best_tests(stage);
  std::vector<TestPair> pairs;
  for (const auto* bulk : best) {
    if (bulk->id.load != Load::bulk || !(bulk->series.unrelaxed() > 0.0)) continue;
    const auto is_shear = [bulk](const TestResult* test) {
      return test->id.load != Load::bulk && test->id.boundary == bulk->id.boundary &&
             test->id.method == bulk->id.method && test->id.grid == bulk->id.grid && test->series.unrelaxed() > 0.0;
    };
    auto shear = std::ranges::find_if(
        best, [&](const TestResult* test) { return is_shear(test) && test->id.load == Load::shear; });
    if (shear == best.end()) shear = std::ranges::find_if(best, is_shear);
    if (shear != best.end()) pairs.push_back({*shear, bulk});
  }
  return pairs;
}

EngineeringCurves curves_of(const TestPair& pair, int dimensions, const FrequencyRows& rows) {
  const auto& shear = pair.shear->series;
  const auto bulk = bulk_modulus_of(pair.bulk->series, shear, dimensions);
  const EngineeringModuli moduli(shear, bulk);
  EngineeringCurves curves{pair.shear->id, {}, {}};
  for (const auto& [time, modulus] : pair.shear->modulus) {
    curves.in_time.push_back(
        {time, shear.at(time), bulk.at(time), moduli.youngs_modulus(time), moduli.poisson_ratio(time)});
  }
  for (const double frequency : rows.of(pair.shear->modulus)) {
    curves.in_frequency.push_back({frequency, shear.complex_modulus(frequency), bulk.complex_modulus(frequency),
                                   moduli.complex_youngs_modulus(frequency), moduli.complex_poisson_ratio(frequency)});
  }
  return curves;
}

}  // namespace

std::vector<EngineeringCurves> engineering_curves(const StageFindings& stage, const FrequencyRows& rows) {
  std::vector<EngineeringCurves> all;
  for (const auto& pair : pairs_of(stage)) all.push_back(curves_of(pair, stage.dimensions, rows));
  return all;
}

}  // namespace breccia
