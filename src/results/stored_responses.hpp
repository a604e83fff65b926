#pragma once

#include <filesystem>
#include <vector>

#include "breccia/homogenisation/stage_responses.hpp"

#include "results/study_document.hpp"

namespace breccia {

/// Reads the reduced responses in a directory of results, `<stage>/response.h5`, of the stages in the record of the
/// study, in the order of the record. Adds the fillers and the warnings of the stages from the record, and a warning
/// for a file without a checksum. Throws InputError where a response belongs to another stage or study, and FileError
/// when a file differs from the form in which `breccia run` writes it.
std::vector<StageResponses> read_stored_responses(const std::filesystem::path& directory,
                                                  const StudyDocument& document);

}  // namespace breccia
