#pragma once

#include <optional>
#include <vector>

#include "breccia/homogenisation/study_result.hpp"

namespace breccia {

/// Whether a test answers for its stage beside the others: one under the periodic boundary, which comes nearest to the
/// material, or, where that is not tested, any.
bool answers(const TestId& test, const std::vector<TestResult>& tests);

/// The largest errors of the tests that answer for a stage, of the preferred grid. Whole errors and those of the
/// packing are those at all times, of shears that have a mean only that of the mean; errors of the grid are those of
/// all loads and methods at whole decades.
struct LargestErrors {
  std::optional<double> whole = {};   ///< the whole error [-]; nothing where it is not known of one test at one time
  std::optional<double> sample = {};  ///< the part of the packing [-]; nothing as above
  std::optional<double> matrix = {};  ///< the part of an earlier stage that is the matrix [-]; nothing as above
  std::optional<double> grid = {};    ///< half band of several grids over the modulus [-]; nothing for one grid
  /// The same of the tests that do not answer, beside those that do.
  std::optional<double> grid_of_others = {};
};

/// The largest errors of the tests of a stage that are done so far.
LargestErrors largest_errors_of(const StageFindings& stage);

}  // namespace breccia
