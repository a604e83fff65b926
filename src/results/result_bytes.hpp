#pragma once

#include <string>

#include "breccia/homogenisation/study_result.hpp"

#include "results/composite.hpp"

namespace breccia {

// Results as bytes, from which bitwise identical results can be made again, for callers that keep results in another
// form than the files of a run. Fields of tests and the records of their computation are left out. Reading throws
// FileError where the bytes do not have this form.

std::string bytes_of(const TestResult& test);
std::string bytes_of(const StageFindings& stage);
std::string bytes_of(const StudyContent& content);

TestResult test_from_bytes(const std::string& bytes);
StageFindings stage_from_bytes(const std::string& bytes);
StudyContent content_from_bytes(const std::string& bytes);

}  // namespace breccia
