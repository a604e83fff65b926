#pragma once

#include <memory>
#include <optional>

#include "breccia/homogenisation/study_event.hpp"
#include "breccia/homogenisation/study_result.hpp"
#include "breccia/progress.hpp"
#include "breccia/study/stage.hpp"
#include "breccia/study/test_id.hpp"

namespace breccia {

class Checkpoint;

/// Follows the solution of a study, receives its results one by one, and provides checkpoints. This base class does
/// nothing, so that the results exist only in memory; a class that writes files overrides the functions that it needs.
/// All functions are called on every process of a group. An exception that they throw ends the solution.
class StudySink {
 public:
  StudySink() = default;
  StudySink(const StudySink&) = delete;
  StudySink& operator=(const StudySink&) = delete;
  StudySink(StudySink&&) = delete;
  StudySink& operator=(StudySink&&) = delete;
  virtual ~StudySink() = default;

  /// Is called whenever the running packing or test has made progress. The quasi-static method computes all loads of a
  /// stage together.
  virtual void progress(const Progress&) {}
  /// Is called for each event of the solution.
  virtual void happened(const StudyEvent&) {}

  /// The result of a stage that is already known, for example from another study with the same stage; nothing if the
  /// stage must be computed.
  virtual std::optional<StageResult> known_stage(const Stage&) { return std::nullopt; }
  /// The checkpoints of a packing, and of a test; nullptr where no state is saved. All loads of a quasi-static test
  /// share one checkpoint, which is that of the test under the first load.
  virtual std::unique_ptr<Checkpoint> packing_checkpoint(const Stage&);
  virtual std::unique_ptr<Checkpoint> test_checkpoint(const Stage&, const TestId&);
  /// Stores the fields of a test; each process holds the fields of its own cells. Returns whether they were stored,
  /// with the same value on every process of a group; if not, the fields stay in the result. The state of a finished
  /// test does not hold its fields: a sink with checkpoints must store them, or a resumed study has none.
  virtual bool store_fields(const Stage&, const TestId&, const TestFields&) { return false; }
};

}  // namespace breccia
