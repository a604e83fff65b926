#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "breccia/assessment/find_input.hpp"
#include "breccia/deckfile/uncertain_input.hpp"

namespace breccia {

/// The directory for the files of a search, and its origin.
struct DesignDestination {
  std::filesystem::path directory;
  std::string source;                ///< deck, samples, condition and value in words
  std::vector<std::string> studies;  ///< hashes of the studies that were solved
};

/// What was searched.
struct SearchedDesign {
  UncertainInput input;
  std::string quantity;       ///< what the condition is about: "G(1 ms)"
  std::string quantity_unit;  ///< SI unit of its value; empty without one
  double wanted = 0.0;        ///< value of the quantity
  double value = 0.0;         ///< of the input, that was found
  Interval interval = {};     ///< 95 % of it; infinite beyond the range
  double reached = 0.0;       ///< value of the quantity of the study with it
  std::vector<DesignPoint> points;
};

/// Writes `found.csv`, the value that was found, and `find.csv` and `find.svg`, what the composite has over the range
/// that was searched, in place of those of an earlier search. Returns the names of the files. Throws FileError.
std::vector<std::string> write_design(const DesignDestination& destination, const SearchedDesign& searched);

}  // namespace breccia
