#pragma once

#include "breccia/dynamics/dynamic_problem.hpp"

namespace breccia::benchmark {

/// 200 equal discs that fill 65 % of a box, whose matrix has so many Maxwell terms in shear, under a ramp of shear.
DynamicProblem<2> model_problem(int cells, int terms);

}  // namespace breccia::benchmark
