#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "breccia/study/study.hpp"
#include "breccia/virtual_test/test_fields.hpp"

#include "results/stage_record.hpp"

namespace breccia {

/// Names of the files of the fields that a test of the first load saves at some times [s]. The file for the first
/// boundary and method at the last time is `fields.vtkhdf`; other names contain the boundary and the method, and the
/// number of an earlier time.
std::vector<FieldRecord> field_records(const Study& study, const TestId& test, const std::vector<double>& times);

/// Writes the fields of a test to the directory of its stage, as VTKHDF and as pictures of stress and strain, to files
/// of these names. Every process calls it with the fields of its cells; the first one writes, and holds a piece of them
/// at a time. Throws FileError there.
std::vector<FieldRecord> write_fields(const std::filesystem::path& directory, const Study& study, const Stage& stage,
                                      const TestId& test, const GridFields<2>& fields);

/// Copies the files of the fields of a stage from one directory to another. Throws FileError.
void copy_fields(const std::filesystem::path& from, const std::filesystem::path& to, const StageRecord& stage);

/// Whether this is the name of a file of fields.
bool is_of_fields(std::string_view name);

}  // namespace breccia
