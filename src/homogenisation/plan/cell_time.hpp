#pragma once

#include "breccia/discretisation/boundary.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// Approximate processor time [s] of a quasi-static test of all loads of a stage under one boundary, on a grid with
/// `cells` cells per side, on a core like that of the measured costs; an empirical formula.
double quasistatic_time(const Study& study, const Stage& stage, Boundary boundary, int cells);

/// Approximate processor time [s] of the discretisation of a stage on a grid with `cells` cells per side, which all of
/// its tests share.
double discretisation_time(const Study& study, const Stage& stage, int cells);

}  // namespace breccia
