#pragma once

#include <memory>
#include <type_traits>

#include <fftw3.h>

namespace breccia::quasistatic {

struct DestroyPlan {
  void operator()(fftw_plan plan) const noexcept { fftw_destroy_plan(plan); }
};

/// A plan of FFTW. It is made by estimates, not by timings, so that every run has the same bits.
using FourierPlan = std::unique_ptr<std::remove_pointer_t<fftw_plan>, DestroyPlan>;

/// Flags of all plans.
inline constexpr unsigned plan_flags = FFTW_ESTIMATE;

}  // namespace breccia::quasistatic
