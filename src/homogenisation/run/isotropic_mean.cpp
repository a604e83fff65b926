#include "homogenisation/run/isotropic_mean.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/viscoelasticity/interconversion.hpp"

namespace breccia {
namespace {

bool has_time(const Curve& curve, double time) {
  return !curve.empty() && curve.front().time <= time && time <= curve.back().time;
}

/// The modulus of a test at a time of the first of the shears, whose sample `index` it is.
double modulus_at(const TestResult& test, std::size_t index, double time) {
  const bool has_same_times = index < test.modulus.size() && test.modulus[index].time == time;
  return has_same_times ? test.modulus[index].modulus : smoothed_at(test.modulus, time);
}

/// The larger one of two errors; NaN, which is an error that is not known, if one of them is NaN.
double larger_error(double one, double other) {
  return std::isnan(one) || one >= other ? one : other;
}

}  // namespace

std::vector<const TestResult*> shears_beside(int dimensions, const TestId& beside,
                                             const std::vector<TestResult>& tests) {
  std::vector<const TestResult*> shears;
  for (const auto load : isotropic_shears(dimensions)) {
    auto id = beside;
    id.load = load;
    const auto test = std::ranges::find(tests, id, &TestResult::id);
    if (test == tests.end()) {
      throw InputError(
          fmt::format("isotropic mean: there is no test under {} by {}", name_of(load), calculation_of(beside)));
    }
    shears.push_back(&*test);
  }
  return shears;
}

TestResult isotropic_mean(int dimensions, const TestId& beside, const std::vector<TestResult>& tests) {
  const auto shears = shears_beside(dimensions, beside, tests);
  const double share = 1.0 / static_cast<double>(shears.size());
  TestResult mean{.id = beside};
  mean.id.load = TestLoad::isotropic();
  const auto& first = shears.front()->modulus;
  for (std::size_t i = 0; i < first.size(); ++i) {
    const double time = first[i].time;
    if (!std::ranges::all_of(shears, [&](const auto* shear) { return has_time(shear->modulus, time); })) continue;
    double modulus = 0.0;
    for (const auto* shear : shears) modulus += share * modulus_at(*shear, i, time);
    mean.modulus.push_back({time, modulus});
  }
  mean.error_estimate = 0.0;
  MeanRecord record;
  for (const auto* shear : shears) {
    mean.series = PronySeries::sum(mean.series, shear->series.scaled(share));
    mean.error_estimate = larger_error(mean.error_estimate, shear->error_estimate);
    record.loads.push_back(*shear->id.load.of_test());
  }
  mean.record = std::move(record);
  const bool is_of_creep = std::ranges::none_of(shears, [](const auto* shear) { return shear->compliance.empty(); });
  if (is_of_creep) {
    const auto compliance = creep_compliance(mean.series);
    for (const auto& [time, modulus] : mean.modulus) mean.compliance.push_back({time, compliance.at(time)});
  }
  return mean;
}

}  // namespace breccia
