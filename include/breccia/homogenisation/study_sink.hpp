#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "breccia/checkpoint/checkpoint.hpp"
#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/stage.hpp"
#include "breccia/study/test_id.hpp"

namespace breccia {

/// Where the parts of a solution go as they are found, and from where calculations that were cut off go on. This class
/// keeps nothing, so that a solution exists in the memory alone; one that writes overrides what it needs. All functions
/// are called on every process of a group. What they throw ends the solution.
class StudySink {
 public:
  StudySink() = default;
  StudySink(const StudySink&) = delete;
  StudySink& operator=(const StudySink&) = delete;
  StudySink(StudySink&&) = delete;
  StudySink& operator=(StudySink&&) = delete;
  virtual ~StudySink() = default;

  /// The states of a packing, of all loads of a quasi-static test, and of a dynamic test; nothing where none are left.
  virtual std::optional<Checkpoint> packing_checkpoint(const Stage&) { return std::nullopt; }
  virtual std::optional<Checkpoint> quasistatic_checkpoint(const Stage&, Boundary, TestGrid) { return std::nullopt; }
  virtual std::optional<Checkpoint> dynamic_checkpoint(const Stage&, const TestId&) { return std::nullopt; }

  /// A stage has its microstructure; it is the last one of the result.
  virtual void packed(const Stage&, const StudyResult&) {}
  /// A time domain of a dynamic test is done, the one of this number, from 1.
  virtual void domain_finished(const Stage&, const TestId&, std::size_t /*number*/, const TimeDomain&) {}
  /// A test has found fields on a discretisation. Returns the files to which they have been written, on every process
  /// of a group or on none; where nothing is returned they stay in the result. States of tests do not hold fields: a
  /// sink that leaves states must take the fields, or they are lost to whoever goes on from there.
  virtual std::optional<std::vector<FieldRecord>> fields(const Stage&, const TestId&, const Discretisation<2>&,
                                                         const std::vector<TimedFields<2>>&) {
    return std::nullopt;
  }
  /// Another test, or the extrapolation of several, is in the result of the last stage.
  virtual void tested(const Stage&, const StudyResult&) {}
  /// All loads of a quasi-static test are in the result of the last stage.
  virtual void all_loads_tested(const Stage&, const StudyResult&) {}
  /// All tests of the last stage are done, and compared with what was measured.
  virtual void stage_finished(const Stage&, const StudyResult&) {}
};

}  // namespace breccia
