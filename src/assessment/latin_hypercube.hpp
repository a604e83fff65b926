#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "breccia/deckfile/uncertain_input.hpp"

namespace breccia {

/// Coordinates of points (inputs x points) that are a Latin hypercube: each input takes every one of `points` equally
/// likely slices of its distribution once, in its middle, and each of its choices as often as the others but for one.
/// Of many random hypercubes it is the one whose largest correlation between two inputs is least. The same seed gives
/// the same points (McKay, Beckman and Conover, Technometrics 21, 1979).
Eigen::MatrixXd latin_hypercube(const std::vector<UncertainInput>& inputs, Eigen::Index points, std::uint64_t seed);

}  // namespace breccia
