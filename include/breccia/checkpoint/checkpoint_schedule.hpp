#pragma once

#include <functional>

namespace breccia {

/// The schedule by which a calculation saves its state.
struct CheckpointSchedule {
  double interval = 600.0;          ///< wall time between two saved states [s]
  std::function<bool()> stop = {};  ///< returns true when the run is to end; called often, on each process
};

}  // namespace breccia
