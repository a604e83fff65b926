#pragma once

#include <string>
#include <utility>
#include <vector>

#include "breccia/homogenisation/study_result.hpp"

namespace breccia::test {

/// The columns of a table of results that distinguish tests.
inline const std::vector<std::string> columns_of_tests{"stage", "load", "boundary", "method", "cells"};

/// A test that has only a curve.
inline TestResult test_with(const TestId& id, Curve modulus) {
  TestResult test{.id = id};
  test.modulus = std::move(modulus);
  return test;
}

inline StageResult stage_with(const std::string& name, std::vector<TestResult> tests) {
  StageResult stage;
  stage.name = name;
  stage.tests = std::move(tests);
  return stage;
}

}  // namespace breccia::test
