#pragma once

#include "breccia/dynamics/instruction_set.hpp"

#include "cell_row_kernel.hpp"

namespace breccia::dynamics {

const KernelTable& kernels(InstructionSet set);

}  // namespace breccia::dynamics
