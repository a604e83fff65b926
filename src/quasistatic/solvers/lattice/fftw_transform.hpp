#pragma once

#include <memory>

#include "quasistatic/solvers/lattice/fourier_transform.hpp"

namespace breccia::quasistatic {

/// Transforms by plans of FFTW, made by estimates, not by timings, so that the results of all runs are bitwise
/// identical. The functions throw NumericalError where FFTW has no plan, because memory is short or there are no values
/// to transform.
[[nodiscard]] std::unique_ptr<WaveTransform> wave_transform_of_fftw(WaveDirection direction, const WaveRows& rows);
[[nodiscard]] std::unique_ptr<RealTransform> real_transform_of_fftw(const RealRows& rows);

}  // namespace breccia::quasistatic
