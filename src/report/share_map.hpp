#pragma once

#include <string>
#include <vector>

namespace breccia {

/// A map of shares between 0 and 1: a row a name, a column a place.
struct ShareMap {
  std::string title;
  std::vector<std::string> rows;            ///< names of the rows
  std::vector<std::string> columns;         ///< names of the columns
  std::vector<std::vector<double>> shares;  ///< by row and column
};

/// SVG of a map of shares: cells whose colour deepens with their share, with its per cent in them.
std::string share_map(const ShareMap& map);

}  // namespace breccia
