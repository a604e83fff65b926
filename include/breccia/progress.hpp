#pragma once

#include <functional>
#include <string>

namespace breccia {

/// How far a calculation has come.
struct Progress {
  std::string what = {};     ///< the calculation: "fine: packing"; empty below solve(), which names its parts
  double share = 0.0;        ///< finished share, 0 to 1
  std::string details = {};  ///< the present work: "snapshot 5, error 1e-03"
};

/// Is called with the progress of a calculation. An exception that it throws ends the calculation.
using ProgressObserver = std::function<void(const Progress&)>;

}  // namespace breccia
