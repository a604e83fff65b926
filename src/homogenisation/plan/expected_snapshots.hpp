#pragma once

#include <vector>

#include "breccia/study/study.hpp"

#include "quasistatic/reduced/carson_path.hpp"

namespace breccia {

/// The moduli of all phases of a stage on the path on which the solutions of a quasi-static test lie, with the expected
/// matrix.
std::vector<CarsonPoint> expected_path(const Study& study, const Stage& stage);

/// Approximate number of snapshots of a reduced basis of a stage, by an empirical formula: it grows with the decades
/// over which the shear moduli of the phases relax, and by a factor for each elastic modulus that varies
/// (Tests::varied). It is one where nothing relaxes and nothing varies.
double expected_snapshots(const Study& study, const Stage& stage);

/// Number of solutions of a run that steps through time, with fine and with coarse steps.
double expected_steps(const Tests& tests);

}  // namespace breccia
