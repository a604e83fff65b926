#pragma once

#include <string_view>
#include <vector>

namespace breccia {

/// The instruction sets for which the inner loop of the total-lagrangian formulation is compiled. All of them give
/// bitwise identical results.
enum class InstructionSet {
  baseline,  ///< the instructions of every processor of the platform: SSE2 on x86-64, NEON on 64-bit ARM
  avx2,      ///< AVX2, on x86-64 alone
  avx512     ///< AVX-512, on x86-64 alone
};

/// The name by which users choose an instruction set: baseline, avx2, avx512.
std::string_view name_of(InstructionSet set);

/// The instruction sets of this processor, the widest last.
std::vector<InstructionSet> supported_instruction_sets();

/// The widest instruction set of this processor, or the one named by the environment variable BRECCIA_INSTRUCTION_SET.
/// Throws InputError when that one is unknown or not supported.
InstructionSet chosen_instruction_set();

}  // namespace breccia
