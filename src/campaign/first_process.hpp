#pragma once

#include "breccia/parallel/session.hpp"

namespace breccia {

/// Calls a function on the first process of the group only, since that one writes the results.
template <class Write>
void write_once(const Write& write) {
  if (parallel::rank() == 0) write();
}

}  // namespace breccia
