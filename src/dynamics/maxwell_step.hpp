#pragma once

#include <vector>

#include "breccia/viscoelasticity/prony_series.hpp"

#include "dynamics/cell_row_kernel.hpp"

namespace breccia::dynamics {

/// Exact steps of the Maxwell terms of a series for a strain that is linear in the time step [s] (theory, Eq. 10).
std::vector<TermStep> maxwell_steps(const PronySeries& series, double time_step);

}  // namespace breccia::dynamics
