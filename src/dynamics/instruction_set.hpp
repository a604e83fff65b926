#pragma once

#include "cell_row_kernel.hpp"

namespace breccia::dynamics {

enum class InstructionSet { baseline, avx2, avx512 };

/// Does this processor have the instruction set?
bool is_supported(InstructionSet set);

/// The widest instruction set of this processor, or the one named by the environment variable BRECCIA_INSTRUCTION_SET
/// (baseline, avx2, avx512). Throws InputError when that one is unknown or not supported.
InstructionSet chosen_instruction_set();

const KernelTable& kernels(InstructionSet set);

}  // namespace breccia::dynamics
