#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "breccia/checkpoint/checkpoint.hpp"
#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/stage.hpp"
#include "breccia/study/test_id.hpp"

namespace breccia {

/// Receives the parts of a solution as they are computed, and provides the checkpoints. This base class does nothing,
/// so that a solution exists only in memory; a class that writes files overrides what it needs. All functions are
/// called on every process of a group. An exception that they throw ends the solution.
class StudySink {
 public:
  StudySink() = default;
  StudySink(const StudySink&) = delete;
  StudySink& operator=(const StudySink&) = delete;
  StudySink(StudySink&&) = delete;
  StudySink& operator=(StudySink&&) = delete;
  virtual ~StudySink() = default;

  /// The checkpoints of a packing, of a quasi-static test (all loads), and of a dynamic test; nothing if no state shall
  /// be saved.
  virtual std::optional<Checkpoint> packing_checkpoint(const Stage&) { return std::nullopt; }
  virtual std::optional<Checkpoint> quasistatic_checkpoint(const Stage&, Boundary, TestGrid) { return std::nullopt; }
  virtual std::optional<Checkpoint> dynamic_checkpoint(const Stage&, const TestId&) { return std::nullopt; }

  /// Is called when a stage has its microstructure; it is the last stage of the result.
  virtual void packed(const Stage&, const StudyResult&) {}
  /// Is called when a time domain of a dynamic test is finished; the number counts from 1.
  virtual void domain_finished(const Stage&, const TestId&, std::size_t /*number*/, const TimeDomain&) {}
  /// Is called with the fields of a test and its discretisation. Returns the files to which they were written, on every
  /// process of a group or on none; if it returns nothing, the fields remain in the result. Checkpoints do not contain
  /// fields: a sink with checkpoints must write the fields, or a resumed run will lack them.
  virtual std::optional<std::vector<FieldRecord>> fields(const Stage&, const TestId&, const Discretisation<2>&,
                                                         const std::vector<TimedFields<2>>&) {
    return std::nullopt;
  }
  /// Is called when a test, or the extrapolation of several, has been added to the last stage of the result.
  virtual void tested(const Stage&, const StudyResult&) {}
  /// Is called when all loads of a quasi-static test have been added to the last stage of the result.
  virtual void all_loads_tested(const Stage&, const StudyResult&) {}
  /// Is called when all tests of the last stage are finished and compared with the measurements.
  virtual void stage_finished(const Stage&, const StudyResult&) {}
};

}  // namespace breccia
