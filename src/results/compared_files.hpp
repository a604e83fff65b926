#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "breccia/assessment/compare_curves.hpp"
#include "breccia/assessment/observation.hpp"

#include "deckfile/deck_differences.hpp"

namespace breccia {

/// Results beside each other.
struct ComparedResults {
  std::vector<std::string> names = {};  ///< of the results: their directories
  ComparedCurves curves = {};
  std::vector<DeckDifference> decks = {};
  std::vector<Observation> measured = {};  ///< measured values, which the pictures show
};

/// The directory for the files of a comparison, and its origin.
struct ComparisonDestination {
  std::filesystem::path directory;
  std::string identity;    ///< text that distinguishes it from others, such as hashes
  bool overwrite = false;  ///< whether another comparison may be replaced
};

/// Writes `compare.csv`, the curves of all results with the ratios to the first, `decks.csv`, and a picture of each
/// modulus. Returns the names of the files. Throws InputError where other files are in the directory, and FileError.
std::vector<std::string> write_compared(const ComparisonDestination& destination, const ComparedResults& compared);

}  // namespace breccia
