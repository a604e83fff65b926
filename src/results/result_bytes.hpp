#pragma once

#include <string>

#include "breccia/homogenisation/study_result.hpp"

#include "results/composite.hpp"

namespace breccia {

// Results as bytes, from which the same bits are made again, for what keeps them beside the files of a run. Fields of
// tests and the records of their computation are left out. Reading throws FileError where the bytes are none of these.

std::string bytes_of(const TestResult& test);
std::string bytes_of(const StageFindings& stage);
std::string bytes_of(const StudyContent& content);

TestResult test_from_bytes(const std::string& bytes);
StageFindings stage_from_bytes(const std::string& bytes);
StudyContent content_from_bytes(const std::string& bytes);

}  // namespace breccia
