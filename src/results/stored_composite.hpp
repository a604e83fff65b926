#pragma once

#include <filesystem>
#include <vector>

#include "breccia/error.hpp"

#include "results/composite.hpp"

namespace breccia {

/// Reads the series of the preferred tests from `prony.csv` in a directory of results. Throws FileError when the file
/// is not as `breccia run` writes it.
std::vector<StageSeries> read_stored_series(const std::filesystem::path& directory);

/// Reads the content of a study, apart from its moduli, from `study.json` in a directory of results. Throws FileError
/// when the file is not as `breccia run` writes it.
StudyContent read_stored_content(const std::filesystem::path& directory);

/// Error: a directory has only curves that were computed from the reduced responses of other results (`breccia
/// respond`).
class AnsweredResults : public InputError {
 public:
  using InputError::InputError;
};

/// Throws InputError where a directory does not have the results of a study with at least one finished test.
void require_stored_study(const std::filesystem::path& directory);

/// Reads the moduli of a composite from `study.json` and `prony.csv`. Throws InputError with every mistake in the
/// choice and with the possible choices, and as require_stored_study(); and FileError.
Composite read_stored_composite(const std::filesystem::path& directory, const CompositeChoice& choice = {});

}  // namespace breccia
