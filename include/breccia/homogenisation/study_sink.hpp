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

/// Follows a solution, receives its parts as they are found, and provides the checkpoints. This base class does
/// nothing, so that a solution exists only in memory; a class that writes files overrides what it needs. All functions
/// are called on every process of a group. An exception that they throw ends the solution.
class StudySink {
 public:
  StudySink() = default;
  StudySink(const StudySink&) = delete;
  StudySink& operator=(const StudySink&) = delete;
  StudySink(StudySink&&) = delete;
  StudySink& operator=(StudySink&&) = delete;
  virtual ~StudySink() = default;

  /// Is called as often as the running packing or test comes further. The quasi-static method computes all loads of a
  /// stage together.
  virtual void progress(const Progress&) {}
  /// Is called for each event of the solution.
  virtual void happened(const StudyEvent&) {}

  /// The result of a stage that is already known, for example from another study with the same stage; nothing if the
  /// stage must be computed.
  virtual std::optional<StageResult> known_stage(const Stage&) { return std::nullopt; }
  /// The states of a packing, and of a test; null where none are left. All loads of a quasi-static test have one state,
  /// which is asked for by the test of the first load.
  virtual std::unique_ptr<Checkpoint> packing_checkpoint(const Stage&);
  virtual std::unique_ptr<Checkpoint> test_checkpoint(const Stage&, const TestId&);
  /// Stores the fields of a test, of which each process has those of its cells. Returns whether it has, alike on every
  /// process of a group; where not, the fields stay in the result. The state of a finished test does not hold its
  /// fields: a sink with checkpoints must store them, or a resumed study has none.
  virtual bool store_fields(const Stage&, const TestId&, const TestFields&) { return false; }
};

}  // namespace breccia
