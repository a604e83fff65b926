#include "solvers/lattice/fourier_plan.hpp"

#include <new>

#include "breccia/error.hpp"

namespace breccia::quasistatic {

FourierPlan made_plan(fftw_plan plan) {
  if (plan == nullptr) {
    throw NumericalError(
        "quasi-static solver: FFTW has no plan for the transforms of this box; the memory may be short, or the box "
        "have "
        "no nodes between its walls");
  }
  return FourierPlan(plan);
}

Waves allocate_waves(std::size_t count) {
  Waves waves(fftw_alloc_complex(count));
  if (waves == nullptr) throw std::bad_alloc();
  return waves;
}

}  // namespace breccia::quasistatic
