#pragma once

#include <functional>

namespace breccia {

/// When a calculation saves its state.
struct CheckpointSchedule {
  double interval = 600.0;          ///< wall time between two saved states [s]
  std::function<bool()> stop = {};  ///< true when the run shall end; called often, on each process
};

}  // namespace breccia
