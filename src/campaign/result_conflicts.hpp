#pragma once

#include <vector>

#include "breccia/campaign/run.hpp"

#include "campaign/earlier_results.hpp"
#include "io/conflicting_results.hpp"

namespace breccia {

/// The reasons why a run must neither resume the results in a directory nor replace them; none if it may. A replacement
/// that was interrupted counts as complete. Changes nothing.
std::vector<ResultConflict> conflicts_with(const EarlierResults& earlier, const RunOptions& options);

/// The reasons why a run cannot resume from these results; none where there are no results.
std::vector<ResultConflict> conflicts_of_resuming(const EarlierResults& earlier);

}  // namespace breccia
