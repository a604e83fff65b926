#pragma once

#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/study.hpp"

#include "results/stage_record.hpp"
#include "results/study_document.hpp"

namespace breccia {

/// What study.json has of a study and its result so far. `records` are those of its stages, by their names.
StudyDocument document_of(const Study& study, const StudyResult& result, const StageRecords& records);

}  // namespace breccia
