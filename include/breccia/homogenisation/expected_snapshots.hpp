#pragma once

#include "breccia/study/study.hpp"

namespace breccia {

/// Approximate number of snapshots of a reduced basis of a stage, by an empirical formula: about ten for the relaxation
/// of the matrix in two dimensions and eight in three, times a factor for each modulus that varies beside it
/// (Tests::varied).
double expected_snapshots(const Tests& tests, const Stage& stage);

}  // namespace breccia
