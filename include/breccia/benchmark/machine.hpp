#pragma once

#include <string>

namespace breccia {

/// What a speed depends on.
struct Machine {
  std::string processor;  ///< as the system calls it; empty where it does not tell
  int cores = 1;          ///< hardware threads that this process may use
  double cache = 0.0;     ///< last level of cache [B]; 0 where the system does not tell
};

Machine this_machine();

}  // namespace breccia
