#pragma once

#include <memory>

#include "quasistatic/solvers/lattice/fourier_transform.hpp"

namespace breccia::quasistatic {

/// Transforms by the port of KISS FFT in Eigen, which need no further library. The functions throw NumericalError where
/// there are no values to transform.
[[nodiscard]] std::unique_ptr<WaveTransform> wave_transform_of_eigen(WaveDirection direction, const WaveRows& rows);
[[nodiscard]] std::unique_ptr<RealTransform> real_transform_of_eigen(const RealRows& rows);

}  // namespace breccia::quasistatic
