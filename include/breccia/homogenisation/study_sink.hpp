#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/stage.hpp"
#include "breccia/study/test_id.hpp"

namespace breccia {

class Checkpoint;

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

  /// The result of a stage that is already known, for example from another study with the same stage; nothing if the
  /// stage must be computed.
  virtual std::optional<StageResult> known_stage(const Stage&) { return std::nullopt; }
  /// Called after a known stage was added to the result and compared with the measurements of this study.
  virtual void stage_adopted(const Stage&, const StudyResult&) {}

  /// The states of a packing, and of a test; null where none are left. The quasi-static method computes all loads of a
  /// stage together: their state is asked for by the test of the first load.
  virtual std::unique_ptr<Checkpoint> packing_checkpoint(const Stage&);
  virtual std::unique_ptr<Checkpoint> test_checkpoint(const Stage&, const TestId&);

  /// Is called when a stage has its microstructure; it is the last stage of the result.
  virtual void packed(const Stage&, const StudyResult&) {}
  /// Is called when a time domain of a dynamic test is finished; the number counts from 1.
  virtual void domain_finished(const Stage&, const TestId&, std::size_t /*number*/, const TimeDomain&) {}
  /// Stores the fields of a test, of which each process has those of its cells. Returns whether it has, alike on every
  /// process of a group; where not, the fields stay in the result. The state of a finished test does not hold its
  /// fields: a sink with checkpoints must store them, or a resumed study has none.
  virtual bool store_fields(const Stage&, const TestId&, const TestFields&) { return false; }
  /// Called for a test that an earlier run has finished, with the times [s] of the fields that were stored then.
  virtual void fields_stored_before(const Stage&, const TestId&, const std::vector<double>& /*times*/) {}
  /// Is called when a test, or the extrapolation of several, has been added to the last stage of the result.
  virtual void tested(const Stage&, const StudyResult&) {}
  /// Is called when all loads of a quasi-static test have been added to the last stage of the result.
  virtual void all_loads_tested(const Stage&, const StudyResult&) {}
  /// Is called when all tests of the last stage are finished and compared with the measurements.
  virtual void stage_finished(const Stage&, const StudyResult&) {}
  /// All stages are done; the result tells its wall time.
  virtual void finished(const StudyResult&) {}
};

}  // namespace breccia
