#include "homogenisation/run/isotropic_mean.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/viscoelasticity/interconversion.hpp"

namespace breccia {
namespace {

using Shears = std::vector<const TestResult*>;

/// The larger one of two errors; NaN, which is an error that is not known, if one of them is NaN.
double larger_error(double one, double other) {
  return std::isnan(one) || one >= other ? one : other;
}

void require_equal_times(const Shears& shears) {
  const auto& first = *shears.front();
  for (const auto* shear : shears) {
    const auto have_one_time = [](const Sample& one, const Sample& other) { return one.time == other.time; };
    if (std::ranges::equal(first.modulus, shear->modulus, have_one_time) &&
        first.compliance.size() == shear->compliance.size()) {
      continue;
    }
    throw InputError(fmt::format("isotropic mean: the curve under {} has other times than that under {}",
                                 name_of(shear->id.load), name_of(first.id.load)));
  }
}

PronySeries mean_of_moduli(const Shears& shears) {
  PronySeries mean;
  for (const auto* shear : shears) {
    mean = PronySeries::sum(mean, shear->series.scaled(1.0 / static_cast<double>(shears.size())));
  }
  return mean;
}

/// The modulus whose creep compliance is the mean of those of the shears.
PronySeries modulus_of_mean_compliance(const Shears& shears) {
  const double share = 1.0 / static_cast<double>(shears.size());
  double instantaneous = 0.0, fluidity = 0.0;
  std::vector<RetardationTerm> terms;
  for (const auto* shear : shears) {
    const auto compliance = creep_compliance(shear->series);
    instantaneous += share * compliance.instantaneous();
    fluidity += share * compliance.fluidity();
    for (const auto& [time, of_term] : compliance.terms()) terms.push_back({time, share * of_term});
  }
  return relaxation_modulus(CreepCompliance(instantaneous, std::move(terms), fluidity));
}

/// The mean of curves at the same times: `samples` are those of a test, `value` the mean quantity of a sample.
template <class Samples, class Value>
Samples mean_curve(const Shears& shears, Samples TestResult::*samples, Value value) {
  Samples mean = shears.front()->*samples;
  for (std::size_t i = 0; i < mean.size(); ++i) {
    double sum = 0.0;
    for (const auto* shear : shears) sum += (shear->*samples)[i].*value;
    mean[i].*value = sum / static_cast<double>(shears.size());
  }
  return mean;
}

}  // namespace

std::vector<const TestResult*> shears_beside(int dimensions, const TestId& beside,
                                             const std::vector<TestResult>& tests) {
  Shears shears;
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
  require_equal_times(shears);
  TestResult mean{.id = beside};
  mean.id.load = TestLoad::isotropic();
  if (beside.boundary == Boundary::traction) {
    mean.series = modulus_of_mean_compliance(shears);
    mean.compliance = mean_curve(shears, &TestResult::compliance, &CreepSample::compliance);
    for (const auto& sample : shears.front()->modulus) {
      mean.modulus.push_back({sample.time, mean.series.at(sample.time)});
    }
  } else {
    mean.series = mean_of_moduli(shears);
    mean.modulus = mean_curve(shears, &TestResult::modulus, &Sample::modulus);
  }
  mean.error_estimate = 0.0;
  MeanRecord record;
  for (const auto* shear : shears) {
    mean.error_estimate = larger_error(mean.error_estimate, shear->error_estimate);
    record.loads.push_back(*shear->id.load.of_test());
  }
  mean.record = std::move(record);
  return mean;
}

bool is_replaced_by_mean(const TestId& test, int dimensions, const std::vector<TestResult>& tests) {
  return is_in_mean(test.load, dimensions) &&
         std::ranges::any_of(tests, [](const TestResult& other) { return other.id.load.is_isotropic(); });
}

}  // namespace breccia
