#pragma once

#include <functional>
#include <string>

#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/stage.hpp"
#include "breccia/study/test_id.hpp"

namespace breccia {

/// Functions that are called while a study is solved, each of which may be empty. What they throw ends the solution.
struct StudyObserver {
  std::function<void(const Stage&, const PackingProgress&)> packing = {};
  std::function<void(const Stage&, const StageResult&)> packed = {};
  /// How far a test has come: its share, 0 to 1, and the present work. The quasi-static method computes all loads of a
  /// stage together; their test is told as that of the first load.
  std::function<void(const Stage&, const TestId&, double share, const std::string& details)> progress = {};
  std::function<void(const Stage&, const TestResult&)> finished = {};
  std::function<void(const Stage&, const TestId&, const TimeDomain&)> domain_finished = {};
};

}  // namespace breccia
