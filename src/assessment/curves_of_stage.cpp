#include "assessment/curves_of_stage.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "virtual_test/bulk_test.hpp"

namespace breccia {
namespace {

/// The loads whose moduli are taken: the main shear, and bulk where it was tested.
std::vector<TestLoad> loads_of(const StageFindings& stage, const TestKind& kind) {
  std::vector<TestLoad> tested;
  for (const auto& test : stage.tests) {
    if (kind_of(test) == kind) tested.push_back(test.id.load);
  }
  const auto shear = main_shear(tested);
  if (!shear) throw InputError(fmt::format("stage {} has no test in shear that could be assessed", stage.name));
  std::vector<TestLoad> loads = {*shear};
  if (std::ranges::find(tested, TestLoad(Load::bulk)) != tested.end()) loads.emplace_back(Load::bulk);
  return loads;
}

}  // namespace

CurvesOfTest::CurvesOfTest(TestLoad load, const TestResult& reference, int dimensions, std::size_t samples)
    : load_(load), is_over_frequency_(!reference.in_frequency.empty()) {
  const auto symbol = load.is_bulk() ? std::string(symbol_of_bulk_test(dimensions)) : std::string("G");
  if (is_over_frequency_) {
    const auto complex = load.is_bulk() && is_plane_strain(dimensions) ? "(" + symbol + ")*" : symbol + "*";
    curves_ = {{.name = "|" + complex + "|", .unit = "Pa", .curve = ObservedCurve::absolute},
               {.name = "phase of " + complex, .unit = "rad", .curve = ObservedCurve::phase}};
    for (const auto& sample : reference.in_frequency) {
      curves_[0].at.push_back(sample.angular_frequency);
      curves_[0].errors.push_back(sample.error);
    }
    curves_[1].at = curves_[0].at;
    curves_[1].errors.resize(curves_[0].at.size());
  } else {
    curves_ = {{.name = symbol, .unit = "Pa"}};
    for (std::size_t i = 0; i < reference.modulus.size(); ++i) {
      curves_[0].at.push_back(reference.modulus[i].time);
      curves_[0].errors.push_back(i < reference.errors.size() ? reference.errors[i].whole() : std::nullopt);
    }
  }
  for (auto& curve : curves_) {
    curve.boundary = reference.id.boundary;
    curve.modulus = load.is_bulk() ? ObservedModulus::bulk : ObservedModulus::shear;
    curve.share_of_shear = load.is_bulk() ? shear_in_bulk_test(dimensions) : 0.0;
    curve.values.resize(static_cast<Eigen::Index>(curve.at.size()), static_cast<Eigen::Index>(samples));
  }
  const auto values = values_of(reference);
  for (std::size_t i = 0; i < curves_.size(); ++i) {
    curves_[i].reference.assign(values.col(static_cast<Eigen::Index>(i)).begin(),
                                values.col(static_cast<Eigen::Index>(i)).end());
  }
}

void CurvesOfTest::take(std::size_t sample, const TestResult& test) {
  const auto values = values_of(test);
  for (std::size_t i = 0; i < curves_.size(); ++i) {
    curves_[i].values.col(static_cast<Eigen::Index>(sample)) = values.col(static_cast<Eigen::Index>(i));
  }
}

Eigen::MatrixXd CurvesOfTest::values_of(const TestResult& test) const {
  const auto size = static_cast<Eigen::Index>(curves_.front().at.size());
  const auto found = is_over_frequency_ ? test.in_frequency.size() : test.modulus.size();
  if (static_cast<Eigen::Index>(found) != size) {
    throw InputError("the boxes of an assessment have curves of different times");
  }
  Eigen::MatrixXd values(size, static_cast<Eigen::Index>(curves_.size()));
  for (Eigen::Index i = 0; i < size; ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (is_over_frequency_) {
      const auto& sample = test.in_frequency[at];
      values(i, 0) = std::hypot(sample.storage, sample.loss);
      values(i, 1) = std::atan2(sample.loss, sample.storage);
    } else {
      values(i, 0) = test.modulus[at].modulus;
    }
  }
  return values;
}

CurvesOfStage::CurvesOfStage(const StageFindings& stage, const TestKind& kind, std::size_t samples) : kind_(kind) {
  for (const auto load : loads_of(stage, kind)) {
    const auto& reference = preferred_test(stage.tests, load, kind.boundary, kind.method);
    tests_.emplace_back(load, reference, stage.dimensions, samples);
  }
}

void CurvesOfStage::take(std::size_t sample, const std::vector<TestResult>& results) {
  for (auto& test : tests_) test.take(sample, preferred_test(results, test.load(), kind_.boundary, kind_.method));
}

std::vector<SampledCurve> CurvesOfStage::curves() && {
  std::vector<SampledCurve> curves;
  for (auto& test : tests_) std::ranges::move(std::move(test).curves(), std::back_inserter(curves));
  return curves;
}

}  // namespace breccia
