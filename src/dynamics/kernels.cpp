#include "dynamics/kernels.hpp"

namespace breccia::dynamics {

extern const Kernels kernels_baseline;
#ifdef BRECCIA_X86_KERNELS
extern const Kernels kernels_avx2;
extern const Kernels kernels_avx512;
#endif

namespace {

const Kernels& kernels_of(InstructionSet set) {
#ifdef BRECCIA_X86_KERNELS
  if (set == InstructionSet::avx2) return kernels_avx2;
  if (set == InstructionSet::avx512) return kernels_avx512;
#endif
  static_cast<void>(set);
  return kernels_baseline;
}

}  // namespace

template <int dim>
const KernelTable<dim>& kernels(InstructionSet set) {
  if constexpr (dim == 2) {
    return kernels_of(set).squares;
  } else {
    return kernels_of(set).cubes;
  }
}

template const KernelTable<2>& kernels(InstructionSet);
template const KernelTable<3>& kernels(InstructionSet);

}  // namespace breccia::dynamics
