#pragma once

#include <cstddef>
#include <memory>
#include <type_traits>

#include <fftw3.h>

namespace breccia::quasistatic {

struct DestroyPlan {
  void operator()(fftw_plan plan) const noexcept { fftw_destroy_plan(plan); }
};

/// A plan of FFTW. It is made by estimates, not by timings, so that every run has the same bits.
using FourierPlan = std::unique_ptr<std::remove_pointer_t<fftw_plan>, DestroyPlan>;

/// A plan that FFTW has made. Throws NumericalError where it could not: the memory is short, or there is nothing to
/// transform.
[[nodiscard]] FourierPlan made_plan(fftw_plan plan);

/// Memory for waves, aligned for the transforms.
struct FreeWaves {
  void operator()(fftw_complex* waves) const noexcept { fftw_free(waves); }
};
using Waves = std::unique_ptr<fftw_complex, FreeWaves>;

/// Throws std::bad_alloc.
[[nodiscard]] Waves allocate_waves(std::size_t count);

/// Flags of all plans.
inline constexpr unsigned plan_flags = FFTW_ESTIMATE;

}  // namespace breccia::quasistatic
