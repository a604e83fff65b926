#include "homogenisation/run/comparison.hpp"

#include <algorithm>
#include <utility>

#include "breccia/homogenisation/study_result.hpp"

#include "study/chain.hpp"

namespace breccia {

std::vector<Comparison> compare(const Study& study, const Stage& stage, const std::vector<TestResult>& tests) {
  std::vector<Comparison> comparisons;
  for (const auto& measurement : study.measurements) {
    if (measurement.stage != stage.name) continue;
    for (const auto boundary : study.tests.boundaries) {
      for (const auto method : study.tests.methods) {
        const auto& test = preferred_test(tests, shear_of_material(study.tests), boundary, method);
        const auto known = measurement.known_within({test.modulus.front().time, test.modulus.back().time});
        if (!known) continue;
        Comparison comparison{measurement.label, test.id, {}};
        for (const auto& [time, modulus] : test.modulus) {
          if (time < known->begin || time > known->end) continue;
          comparison.samples.push_back({time, modulus, measurement.at(time)});
        }
        if (!comparison.samples.empty()) comparisons.push_back(std::move(comparison));
      }
    }
  }
  return comparisons;
}

}  // namespace breccia
