#pragma once

#include <map>
#include <string>
#include <vector>

#include "breccia/study/test_id.hpp"

namespace breccia {

/// Where the fields of a test at one time have been written: names of files in the directory of its stage.
struct FieldRecord {
  double time = 0.0;  ///< [s]
  std::string file;   ///< VTKHDF
  std::string stress_picture, strain_picture;
};

/// The files of all fields of a test.
struct TestFields {
  TestId test;
  std::vector<FieldRecord> files;
};

/// What a directory tells of a stage beside its result.
struct StageRecord {
  std::vector<TestFields> fields = {};
  /// The task of a sweep whose reduced responses gave the tests at another temperature; empty where they were computed.
  std::string answered_from = {};

  /// The files of the fields of a test; none where it has left none.
  [[nodiscard]] std::vector<FieldRecord> fields_of(const TestId& test) const;
};

/// By the names of the stages.
using StageRecords = std::map<std::string, StageRecord>;

}  // namespace breccia
