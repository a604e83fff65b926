#pragma once

#include <filesystem>

#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/study.hpp"

#include "results/stage_record.hpp"
#include "results/study_document.hpp"

namespace breccia {

/// Writes `study.json` to a directory: the request, the origin of every number, and further records of the stages.
/// Returns the content of the file. Throws FileError.
StudyDocument write_provenance(const std::filesystem::path& directory, const Study& study, const StudyResult& result,
                               const StageRecords& records = {});

}  // namespace breccia
