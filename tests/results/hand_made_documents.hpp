#pragma once

#include <string>
#include <utility>
#include <vector>

#include "results/study_document.hpp"

namespace breccia::test {

/// The record of a study with one stage and its tests, without any further data.
inline StudyDocument document_with(const std::string& stage, std::vector<TestEntry> tests = {}) {
  StudyDocument document;
  document.program = "breccia";
  document.title = "t";
  auto& entry = document.stages.emplace_back();
  entry.name = stage;
  entry.tests = std::move(tests);
  return document;
}

}  // namespace breccia::test
