#pragma once

namespace breccia {

/// What counts as time where speed is measured.
enum class Clock {
  wall,      ///< what a user waits
  processor  ///< mean over the threads of what they got: leaves out other programs, but for what they do to the caches
};

}  // namespace breccia
