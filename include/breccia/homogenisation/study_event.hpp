#pragma once

#include <cstddef>
#include <variant>
#include <vector>

#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/stage.hpp"
#include "breccia/study/test_id.hpp"

namespace breccia {

// Events of the solution of a study. `result` holds all results so far; an event concerns the last stage in it.

/// Event: a stage that was known before was added to the result and compared with the measurements of this study.
struct StageAdopted {
  const Stage& stage;
  const StudyResult& result;
};

/// Event: the microstructure of a stage has been made.
struct StagePacked {
  const Stage& stage;
  const StudyResult& result;
};

/// Event: a time domain of a dynamic test is finished.
struct DomainFinished {
  const Stage& stage;
  TestId test;
  std::size_t number = 1;  ///< number of the time domain, from 1
  const TimeDomain& domain;
};

/// Event: a test was finished by an earlier run, as its saved state shows, which has stored the fields at these times
/// [s].
struct FieldsStoredBefore {
  const Stage& stage;
  TestId test;
  std::vector<double> times;
};

/// Event: a test, or the extrapolation of several tests, was added to the last stage. It is the last test of that
/// stage.
struct TestFinished {
  const Stage& stage;
  const StudyResult& result;
};

/// Event: the results of a quasi-static test under all loads were added to the last stage.
struct AllLoadsFinished {
  const Stage& stage;
  const StudyResult& result;
};

/// Event: all tests of the last stage are finished and compared with the measurements.
struct StageFinished {
  const Stage& stage;
  const StudyResult& result;
};

/// Event: all stages are finished; the result has its wall time.
struct StudyFinished {
  const StudyResult& result;
};

using StudyEvent = std::variant<StageAdopted, StagePacked, DomainFinished, FieldsStoredBefore, TestFinished,
                                AllLoadsFinished, StageFinished, StudyFinished>;

}  // namespace breccia
