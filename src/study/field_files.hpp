#pragma once

#include <vector>

#include "breccia/discretisation/point_fields.hpp"

#include "stage_tests.hpp"

namespace breccia {

/// Times [s] at which a test of a stage leaves its fields: of the first load, on the finest grid.
std::vector<double> field_times_of(const Study& study, const Stage& stage, const Discretisation<2>& discretisation,
                                   Load load);

/// Writes the fields of a test of the first load, as VTKHDF and as pictures of stress and strain. Those of the first
/// boundary and method at the last time are `fields.vtkhdf`; the names of others tell their boundary and method, and
/// the place of an earlier time.
std::vector<FieldRecord> write_fields(const StageGrid& grid, Boundary boundary, Method method,
                                      const std::vector<TimedFields<2>>& fields);

/// Copies the files of the fields of tests from one directory to another. Throws FileError.
void copy_fields(const std::filesystem::path& from, const std::filesystem::path& to,
                 const std::vector<TestResult>& tests);

/// Is this the name of one of these files?
bool is_of_fields(std::string_view name);

}  // namespace breccia
