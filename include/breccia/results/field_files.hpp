#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "breccia/discretisation/discretisation.hpp"
#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// Writes the fields of a test of the first load to the directory of its stage, as VTKHDF and as pictures of stress and
/// strain. The file for the first boundary and method at the last time is `fields.vtkhdf`; the names of the other files
/// contain their boundary and method, and the number of an earlier time. Throws FileError.
std::vector<FieldRecord> write_fields(const std::filesystem::path& directory, const Study& study, const Stage& stage,
                                      const TestId& test, const Discretisation<2>& discretisation,
                                      const std::vector<TimedFields<2>>& fields);

/// Copies the files with the fields of tests from one directory to another. Throws FileError.
void copy_fields(const std::filesystem::path& from, const std::filesystem::path& to,
                 const std::vector<TestResult>& tests);

/// Whether this is the name of such a file.
bool is_of_fields(std::string_view name);

}  // namespace breccia
