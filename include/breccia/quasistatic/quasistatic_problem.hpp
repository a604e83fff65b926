#pragma once

#include <vector>

#include "breccia/discretisation/boundary.hpp"
#include "breccia/discretisation/crystals.hpp"
#include "breccia/discretisation/discretisation.hpp"
#include "breccia/discretisation/load.hpp"
#include "breccia/discretisation/volumetric.hpp"
#include "breccia/quasistatic/linear_options.hpp"
#include "breccia/viscoelasticity/material.hpp"

namespace breccia {

/// A composite without inertia, the problem of both quasi-static solvers, in 2 or 3 dimensions. Every point must have a
/// material.
template <int dim>
struct QuasistaticProblem {
  Discretisation<dim> discretisation;
  std::vector<Material> materials;  ///< materials by PhaseIndex
  Volumetric volumetric = Volumetric::averaged;
  Boundary boundary = Boundary::displacement;
  LinearOptions linear = {};
  /// Phases that are not isotropic. They are elastic, and their stiffness replaces the moduli of their materials.
  Crystals crystals = {};
};

}  // namespace breccia
