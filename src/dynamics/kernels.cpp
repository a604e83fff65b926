#include "kernels.hpp"

namespace breccia::dynamics {

extern const KernelTable<2> kernels_baseline;
extern const KernelTable<3> cube_kernels_baseline;
#ifdef BRECCIA_X86_KERNELS
extern const KernelTable<2> kernels_avx2;
extern const KernelTable<2> kernels_avx512;
extern const KernelTable<3> cube_kernels_avx2;
extern const KernelTable<3> cube_kernels_avx512;
#endif

namespace {

/// The tables for every instruction set.
template <int dim>
struct Tables {
  const KernelTable<dim>& baseline;
  const KernelTable<dim>& avx2;
  const KernelTable<dim>& avx512;
};

template <int dim>
Tables<dim> tables();

#ifdef BRECCIA_X86_KERNELS
template <>
Tables<2> tables() {
  return {kernels_baseline, kernels_avx2, kernels_avx512};
}

template <>
Tables<3> tables() {
  return {cube_kernels_baseline, cube_kernels_avx2, cube_kernels_avx512};
}
#else
template <>
Tables<2> tables() {
  return {kernels_baseline, kernels_baseline, kernels_baseline};
}

template <>
Tables<3> tables() {
  return {cube_kernels_baseline, cube_kernels_baseline, cube_kernels_baseline};
}
#endif

}  // namespace

template <int dim>
const KernelTable<dim>& kernels(InstructionSet set) {
  const auto all = tables<dim>();
  switch (set) {
    case InstructionSet::avx2:
      return all.avx2;
    case InstructionSet::avx512:
      return all.avx512;
    case InstructionSet::baseline:
      break;
  }
  return all.baseline;
}

template const KernelTable<2>& kernels(InstructionSet);
template const KernelTable<3>& kernels(InstructionSet);

}  // namespace breccia::dynamics
