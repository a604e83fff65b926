#include "instruction_set.hpp"

#include <cstdlib>
#include <string_view>

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia::dynamics {

extern const KernelTable kernels_baseline;
extern const KernelTable kernels_avx2;
extern const KernelTable kernels_avx512;

bool is_supported(InstructionSet set) {
  switch (set) {
    case InstructionSet::baseline:
      return true;
    case InstructionSet::avx2:
      return __builtin_cpu_supports("avx2") != 0;
    case InstructionSet::avx512:
      return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
             __builtin_cpu_supports("avx512vl") != 0;
  }
  return false;
}

InstructionSet chosen_instruction_set() {
  if (const char* name = std::getenv("BRECCIA_INSTRUCTION_SET"); name != nullptr) {
    const std::string_view wanted = name;
    for (const auto& [set, known] :
         {std::pair{InstructionSet::baseline, "baseline"}, std::pair{InstructionSet::avx2, "avx2"},
          std::pair{InstructionSet::avx512, "avx512"}}) {
      if (wanted == known && is_supported(set)) return set;
    }
    throw InputError(fmt::format(
        "BRECCIA_INSTRUCTION_SET: expected baseline, avx2 or avx512, and one that this processor has, got '{}'", name));
  }
  if (is_supported(InstructionSet::avx512)) return InstructionSet::avx512;
  return is_supported(InstructionSet::avx2) ? InstructionSet::avx2 : InstructionSet::baseline;
}

const KernelTable& kernels(InstructionSet set) {
  switch (set) {
    case InstructionSet::avx2:
      return kernels_avx2;
    case InstructionSet::avx512:
      return kernels_avx512;
    case InstructionSet::baseline:
      break;
  }
  return kernels_baseline;
}

}  // namespace breccia::dynamics
