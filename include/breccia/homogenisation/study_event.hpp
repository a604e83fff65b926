#pragma once

#include <cstddef>
#include <variant>
#include <vector>

#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/stage.hpp"
#include "breccia/study/test_id.hpp"

namespace breccia {

// What happens while a study is solved. `result` is all that has been found; its last stage is the one that is meant.

/// A stage that was known before was added to the result and compared with the measurements of this study.
struct StageAdopted {
  const Stage& stage;
  const StudyResult& result;
};

/// A stage has its microstructure.
struct StagePacked {
  const Stage& stage;
  const StudyResult& result;
};

/// A time domain of a dynamic test is finished.
struct DomainFinished {
  const Stage& stage;
  TestId test;
  std::size_t number = 1;  ///< from 1
  const TimeDomain& domain;
};

/// An earlier run has finished a test, as its saved state shows, and has stored its fields at these times [s].
struct FieldsStoredBefore {
  const Stage& stage;
  TestId test;
  std::vector<double> times;
};

/// A test, or the extrapolation of several, was added to the last stage: it is the last of its tests.
struct TestFinished {
  const Stage& stage;
  const StudyResult& result;
};

/// All loads of a quasi-static test were added to the last stage.
struct AllLoadsFinished {
  const Stage& stage;
  const StudyResult& result;
};

/// All tests of the last stage are finished and compared with the measurements.
struct StageFinished {
  const Stage& stage;
  const StudyResult& result;
};

/// All stages are finished; the result has its wall time.
struct StudyFinished {
  const StudyResult& result;
};

using StudyEvent = std::variant<StageAdopted, StagePacked, DomainFinished, FieldsStoredBefore, TestFinished,
                                AllLoadsFinished, StageFinished, StudyFinished>;

}  // namespace breccia
