#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/study.hpp"
#include "breccia/study/test_id.hpp"

namespace breccia {

class Checkpoint;

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

  /// The result of a stage that is known before it is computed, as that of the same stage in another study; nothing
  /// where the stage is to be computed.
  virtual std::optional<StageResult> known_stage(const Stage&) { return std::nullopt; }
  /// A stage that was known is the last one of the result, compared with what this study has measured.
  virtual void stage_adopted(const Stage&, const StudyResult&) {}

  /// The states of a packing, and of a test; null where none are left. The quasi-static method computes all loads of a
  /// stage together: their state is asked for by the test of the first load.
  virtual std::unique_ptr<Checkpoint> packing_checkpoint(const Stage&);
  virtual std::unique_ptr<Checkpoint> test_checkpoint(const Stage&, const TestId&);

  /// A stage has its microstructure; it is the last one of the result.
  virtual void packed(const Stage&, const StudyResult&) {}
  /// A time domain of a dynamic test is done, the one of this number, from 1.
  virtual void domain_finished(const Stage&, const TestId&, std::size_t /*number*/, const TimeDomain&) {}
  /// A test has found fields on a discretisation. Returns whether they were taken, the same on every process of a
  /// group; where not, they stay in the result. States of tests do not hold fields: a sink that leaves states must take
  /// the fields, or they are lost to whoever goes on from there.
  virtual bool take_fields(const Stage&, const TestId&, const Discretisation<2>&, const std::vector<TimedFields<2>>&) {
    return false;
  }
  /// The state of a test says that it was finished, and that its fields at these times [s] were taken then.
  virtual void fields_taken_before(const Stage&, const TestId&, const std::vector<double>& /*times*/) {}
  /// Another test, or the extrapolation of several, is in the result of the last stage.
  virtual void tested(const Stage&, const StudyResult&) {}
  /// All loads of a quasi-static test are in the result of the last stage.
  virtual void all_loads_tested(const Stage&, const StudyResult&) {}
  /// All tests of the last stage are done, and compared with what was measured.
  virtual void stage_finished(const Stage&, const StudyResult&) {}
  /// All stages are done; the result tells its wall time.
  virtual void finished(const StudyResult&) {}
};

}  // namespace breccia
