#pragma once

#include <map>
#include <string>
#include <vector>

#include "breccia/study/test_id.hpp"

namespace breccia {

/// The files with the fields of a test at one time, by their names in the directory of the stage.
struct FieldRecord {
  double time = 0.0;  ///< time of the fields [s]
  std::string file;   ///< name of the VTKHDF file
  std::string stress_picture, strain_picture;
  std::string work_picture = {};  ///< picture of the work in grains and films; empty for cells

  /// The names of all these files.
  [[nodiscard]] std::vector<std::string> names() const;
};

/// The files of all fields of a test.
struct TestFieldFiles {
  TestId test;
  std::vector<FieldRecord> files;
};

/// The record of a stage in a directory, in addition to its result.
struct StageRecord {
  std::vector<TestFieldFiles> fields = {};
  /// The task of a sweep from whose reduced responses these tests were obtained; empty if they were computed.
  std::string answered_from = {};

  /// The files of the fields of a test; none where it has not saved any.
  [[nodiscard]] std::vector<FieldRecord> fields_of(const TestId& test) const;
};

/// The records by the names of the stages.
using StageRecords = std::map<std::string, StageRecord>;

}  // namespace breccia
