#pragma once

#include <string>

namespace breccia {

/// The properties of a machine that determine the speed.
struct Machine {
  std::string processor;  ///< model name from the operating system; empty if unknown
  int cores = 1;          ///< hardware threads that this process may use
  double cache = 0.0;     ///< size of the last-level cache [B]; 0 if unknown
};

/// The machine that runs this process.
Machine this_machine();

}  // namespace breccia
