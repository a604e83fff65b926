#pragma once

#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/study.hpp"

#include "results/stage_record.hpp"
#include "results/study_document.hpp"

namespace breccia {

/// The content of study.json for a study and its result so far. `records` are the records of its stages, by their
/// names.
StudyDocument document_of(const Study& study, const StudyResult& result, const StageRecords& records);

}  // namespace breccia
