#pragma once

#include "breccia/discretisation/boundary.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// Approximate processor time [s] of a quasi-static test of all loads of a stage under one boundary, on a grid with
/// `cells` cells per side, on a core of the year 2020; an empirical formula.
double quasistatic_time(const Study& study, const Stage& stage, Boundary boundary, int cells);

}  // namespace breccia
