#include "assessment/sampled_curves.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "assessment/preferred_boundary.hpp"
#include "parallel/first_exception.hpp"
#include "parallel/threads.hpp"
#include "virtual_test/bulk_test.hpp"

namespace breccia {
namespace {

/// The loads whose moduli are assessed: the main shear, and bulk where it was tested.
std::vector<TestLoad> loads_of(const StageFindings& stage) {
  std::vector<TestLoad> tested;
  for (const auto& test : stage.tests) tested.push_back(test.id.load);
  const auto shear = main_shear(tested);
  if (!shear) throw InputError(fmt::format("stage {} has no test in shear that could be assessed", stage.name));
  std::vector<TestLoad> loads = {*shear};
  if (std::ranges::find(tested, TestLoad(Load::bulk)) != tested.end()) loads.emplace_back(Load::bulk);
  return loads;
}

/// Fills curves from the result of a test: one curve, or, over frequency, the absolute value and the phase.
class CurvesOfTest {
 public:
  CurvesOfTest(TestLoad load, const TestResult& reference, int dimensions, std::size_t samples)
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

  [[nodiscard]] TestLoad load() const noexcept { return load_; }

  void take(std::size_t sample, const TestResult& test) {
    const auto values = values_of(test);
    for (std::size_t i = 0; i < curves_.size(); ++i) {
      curves_[i].values.col(static_cast<Eigen::Index>(sample)) = values.col(static_cast<Eigen::Index>(i));
    }
  }

  [[nodiscard]] std::vector<SampledCurve> curves() && { return std::move(curves_); }

 private:
  /// The values of a test (at x curves).
  [[nodiscard]] Eigen::MatrixXd values_of(const TestResult& test) const {
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

  TestLoad load_;
  bool is_over_frequency_;
  std::vector<SampledCurve> curves_;
};

/// Throws NumericalError where a modulus is not positive, as where a sample has all but relaxed.
void require_positive(const SampledCurve& curve) {
  if (curve.curve == ObservedCurve::phase) return;
  for (std::size_t i = 0; i < curve.at.size(); ++i) {
    if (curve.values.row(static_cast<Eigen::Index>(i)).minCoeff() > 0.0) continue;
    throw NumericalError(
        fmt::format("{} at {:.3g} {} is not positive in a sample, which has all but relaxed: end the times of the "
                    "tests earlier",
                    curve.name, curve.at[i], is_over_frequency(curve.curve) ? "rad/s" : "s"));
  }
}

/// The method whose results are taken: the quasi-static one, or else the dynamic one.
Method method_of(const std::vector<TestResult>& tests) {
  const auto is_quasistatic = [](const TestResult& test) { return test.id.method == Method::quasistatic; };
  return std::ranges::any_of(tests, is_quasistatic) ? Method::quasistatic : Method::dynamic;
}

/// The moduli of a stage that are assessed, by its test of each.
class CurvesOfStage {
 public:
  CurvesOfStage(const StageFindings& stage, std::size_t samples)
      : boundary_(preferred_boundary(stage.tests, [](const TestResult& test) { return test.id.boundary; })),
        method_(method_of(stage.tests)) {
    for (const auto load : loads_of(stage)) {
      tests_.emplace_back(load, preferred_test(stage.tests, load, boundary_, method_), stage.dimensions, samples);
    }
  }

  void take(std::size_t sample, const std::vector<TestResult>& results) {
    for (auto& test : tests_) test.take(sample, preferred_test(results, test.load(), boundary_, method_));
  }
  [[nodiscard]] std::vector<SampledCurve> curves() && {
    std::vector<SampledCurve> curves;
    for (auto& test : tests_) std::ranges::move(std::move(test).curves(), std::back_inserter(curves));
    std::ranges::for_each(curves, require_positive);
    return curves;
  }

 private:
  Boundary boundary_;
  Method method_;
  std::vector<CurvesOfTest> tests_;
};

}  // namespace

std::vector<SampledCurve> sample_curves(const SampledStage& stage) {
  const auto samples = stage.box_of.size();
  CurvesOfStage curves(stage.reference, samples);
  std::vector<Responder> boxes;
  for (const auto& box : stage.boxes) boxes.push_back(box.chain_of(stage.reference.name));
  parallel::FirstException failure;
#pragma omp parallel for num_threads(parallel::threads_for(stage.threads)) schedule(dynamic)
  for (std::size_t sample = 0; sample < samples; ++sample) {
    failure.run([&] {
      const auto results = boxes[stage.box_of[sample]].with(stage.materials[sample]).respond();
      curves.take(sample, results.back().tests);
    });
  }
  failure.rethrow();
  return std::move(curves).curves();
}

std::vector<SampledCurve> curves_of(const StageFindings& stage) {
  CurvesOfStage curves(stage, 1);
  curves.take(0, stage.tests);
  return std::move(curves).curves();
}

}  // namespace breccia
