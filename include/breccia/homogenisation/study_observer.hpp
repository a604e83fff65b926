#pragma once

#include <functional>
#include <string>

#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/stage.hpp"

namespace breccia {

/// Functions that are called while a study is solved; each of them may be empty. An exception that they throw ends the
/// solution.
struct StudyObserver {
  std::function<void(const Stage&, const PackingProgress&)> packing = {};
  std::function<void(const Stage&, const StageResult&)> packed = {};
  std::function<void(const Stage&, const std::string& test, double share, const std::string& details)> progress = {};
  std::function<void(const Stage&, const TestResult&)> finished = {};
  std::function<void(const Stage&, const TestId&, const TimeDomain&)> domain_finished = {};
};

}  // namespace breccia
