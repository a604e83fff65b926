#pragma once

#include "dynamics/dynamic_problem.hpp"

namespace breccia::benchmark {

/// 200 equal discs that fill 65 % of a box, or as many spheres that fill 40 % of a cube, under a ramp of shear. The
/// shear modulus of the matrix has `terms` terms. Instantiated for 2 and 3 dimensions.
template <int dim>
DynamicProblem<dim> model_problem(int cells, int terms, Mixing mixing);

}  // namespace breccia::benchmark
