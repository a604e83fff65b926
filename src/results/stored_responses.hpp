#pragma once

#include <filesystem>
#include <vector>

#include "breccia/homogenisation/stage_responses.hpp"

#include "results/study_document.hpp"

namespace breccia {

/// The reduced responses in a directory of results, `<stage>/response.h5`, of the stages in its record, in their order,
/// with the fillers and the warnings of their stages from the record of the study; a warning is added for a file
/// without a checksum. Throws InputError where a response is of another stage or study, and FileError when a file is
/// not as `breccia run` writes it.
std::vector<StageResponses> read_stored_responses(const std::filesystem::path& directory,
                                                  const StudyDocument& document);

}  // namespace breccia
