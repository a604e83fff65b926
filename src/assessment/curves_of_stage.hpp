#pragma once

#include <cstddef>
#include <vector>

#include "breccia/assessment/assess.hpp"
#include "breccia/assessment/stage_curves.hpp"
#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/test_load.hpp"

namespace breccia {

/// The curves of one test in some samples: one curve, or, over frequency, the absolute value and the phase.
class CurvesOfTest {
 public:
  CurvesOfTest(TestLoad load, const TestResult& reference, int dimensions, std::size_t samples);

  [[nodiscard]] TestLoad load() const noexcept { return load_; }
  /// Takes the curves of a sample. Throws InputError where they have other times than the reference.
  void take(std::size_t sample, const TestResult& test);
  [[nodiscard]] std::vector<SampledCurve> curves() && { return std::move(curves_); }

 private:
  /// The values of a test (at x curves).
  [[nodiscard]] Eigen::MatrixXd values_of(const TestResult& test) const;

  TestLoad load_;
  bool is_over_frequency_;
  std::vector<SampledCurve> curves_;
};

/// The curves of a stage in some samples: of G and, where it was tested, of the modulus of the bulk test.
class CurvesOfStage {
 public:
  /// Throws InputError where the stage has no test of this kind in shear.
  CurvesOfStage(const StageFindings& stage, const TestKind& kind, std::size_t samples);

  /// Takes the curves of a sample from the results of its tests.
  void take(std::size_t sample, const std::vector<TestResult>& results);
  [[nodiscard]] std::vector<SampledCurve> curves() &&;

 private:
  TestKind kind_;
  std::vector<CurvesOfTest> tests_;
};

}  // namespace breccia
