#pragma once

namespace breccia {

/// The kind of time by which speeds are measured.
enum class Clock {
  wall,      ///< wall time
  processor  ///< mean processor time of the threads: unaffected by other programs, except through the caches
};

}  // namespace breccia
