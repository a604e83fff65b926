#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "breccia/assessment/find_input.hpp"

namespace breccia {

/// The directory for the files of a search, and its origin.
struct DesignDestination {
  std::filesystem::path directory;
  std::string source;                ///< deck, samples and condition in words
  std::vector<std::string> studies;  ///< hashes of the studies that were solved
};

/// What was searched.
struct SearchedDesign {
  std::string input;          ///< path of the input in the deck
  std::string input_unit;     ///< SI unit of the input; empty without one
  std::string quantity;       ///< what the condition is about: "G(1 ms)"
  std::string quantity_unit;  ///< SI unit of its value; empty without one
  double wanted = 0.0;        ///< value of the quantity
  std::vector<DesignPoint> points;
};

/// Writes `find.csv` and `find.svg`, what the composite has over the range that was searched, in place of those of an
/// earlier search. Returns the names of the files. Throws FileError.
std::vector<std::string> write_design(const DesignDestination& destination, const SearchedDesign& searched);

}  // namespace breccia
