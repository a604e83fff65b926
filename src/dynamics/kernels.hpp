#pragma once

#include "dynamics/cell_row_kernel.hpp"
#include "dynamics/instruction_set.hpp"

namespace breccia::dynamics {

/// Instantiated for 2 and 3 dimensions.
template <int dim>
const KernelTable<dim>& kernels(InstructionSet set);

}  // namespace breccia::dynamics
