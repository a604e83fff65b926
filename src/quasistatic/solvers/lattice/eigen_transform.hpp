#pragma once

#include <memory>

#include "quasistatic/solvers/lattice/fourier_transform.hpp"

namespace breccia::quasistatic {

/// Transforms by the port of KISS FFT in Eigen, which takes no further library. Throw NumericalError where there is
/// nothing to transform.
[[nodiscard]] std::unique_ptr<WaveTransform> wave_transform_of_eigen(WaveDirection direction, const WaveRows& rows);
[[nodiscard]] std::unique_ptr<RealTransform> real_transform_of_eigen(const RealRows& rows);

}  // namespace breccia::quasistatic
