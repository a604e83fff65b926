#pragma once

#include "breccia/parallel/session.hpp"

namespace breccia {

/// Results are written by the first of several processes.
template <class Write>
void write_once(const Write& write) {
  if (parallel::rank() == 0) write();
}

}  // namespace breccia
