#pragma once

#include <functional>
#include <string>

namespace breccia {

/// The progress of a calculation.
struct Progress {
  /// Name of the calculation: "fine: packing"; empty in functions that solve() calls, which adds the name.
  std::string what = {};
  double share = 0.0;        ///< finished share, 0 to 1
  std::string details = {};  ///< the present work: "snapshot 5, error 1e-03"
};

/// A function that is called with the progress of a calculation. An exception that it throws ends the calculation.
using ProgressObserver = std::function<void(const Progress&)>;

}  // namespace breccia
