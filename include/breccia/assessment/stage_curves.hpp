#pragma once

#include <optional>
#include <vector>

#include "breccia/assessment/assess.hpp"
#include "breccia/discretisation/boundary.hpp"
#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/test_id.hpp"

namespace breccia {

/// What the tests of a stage that are taken together share.
struct TestKind {
  Boundary boundary = Boundary::periodic;
  Method method = Method::quasistatic;

  friend bool operator==(const TestKind& one, const TestKind& other) {
    return one.boundary == other.boundary && one.method == other.method;
  }
};

TestKind kind_of(const TestResult& test);

/// The kinds of the tests in shear that a stage has, each once: quasi-static ones before dynamic ones, and of either
/// periodic ones first. Throws InputError where there is none.
std::vector<TestKind> kinds_of(const StageFindings& stage);

/// The first of the kinds of the first stage that all stages have; nothing where there is none.
std::optional<TestKind> shared_kind(const std::vector<StageFindings>& stages);

/// The curves for which a stage was solved, one sample each: G and, where it was tested, the modulus of the bulk test,
/// over frequency |G*| and the phase. A relaxation modulus ends before the first time at which it is not positive.
/// Throws InputError where the stage has no such test in shear.
std::vector<SampledCurve> curves_of(const StageFindings& stage, const TestKind& kind);

}  // namespace breccia
