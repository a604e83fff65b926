#pragma once

#include "breccia/dynamics/dynamic_problem.hpp"

namespace breccia::benchmark {

/// 200 equal discs that fill 65 % of a box, under a ramp of shear. The shear modulus of the matrix has `terms` terms.
DynamicProblem<2> model_problem(int cells, int terms, Mixing mixing);

}  // namespace breccia::benchmark
