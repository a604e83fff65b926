#include "kernels.hpp"

namespace breccia::dynamics {

extern const KernelTable kernels_baseline;
#ifdef BRECCIA_X86_KERNELS

extern const KernelTable kernels_avx2;
extern const KernelTable kernels_avx512;

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

#else

const KernelTable& kernels(InstructionSet /*set*/) {
  return kernels_baseline;
}

#endif

}  // namespace breccia::dynamics
