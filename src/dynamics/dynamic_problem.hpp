#pragma once

#include <vector>

#include "breccia/discretisation/boundary.hpp"
#include "breccia/discretisation/discretisation.hpp"
#include "breccia/discretisation/load.hpp"
#include "breccia/discretisation/tensor.hpp"
#include "breccia/discretisation/volumetric.hpp"
#include "breccia/dynamics/formulation.hpp"
#include "breccia/viscoelasticity/material.hpp"

namespace breccia {

/// Raised-cosine ramp from 0 to 1: its rate is (1 + cos(2 pi t / T)) / T for |t| < T / 2. Time counts from the
/// midpoint, so that the responses of a hereditary material to the ramp and to a step differ only in second
/// order (theory, Eq. 13).
class StrainRamp {
 public:
  /// Duration T [s]; a ramp of duration 0 is a step. Throws InputError when negative.
  explicit StrainRamp(double duration = 0.0);
  [[nodiscard]] double duration() const noexcept { return duration_; }
  /// Share of the load reached at time t [s], 0 to 1.
  [[nodiscard]] double at(double t) const noexcept;

 private:
  double duration_;
};

/// The problem of one dynamic run, for both formulations. It is linear; results are per unit of the load.
template <int dim>
struct DynamicProblem {
  Discretisation<dim> discretisation;
  std::vector<Material> materials;  ///< materials by PhaseIndex
  Volumetric volumetric = Volumetric::averaged;
  double mass_scaling = 1.0;  ///< mass scaling factor: multiplies all masses [-]
  double time_step = 0.0;     ///< time step [s]; at most stable_time_step
  Boundary boundary = Boundary::displacement;
  Strain<dim> load = {};      ///< mean strain at the end of the ramp [-]; unused under a traction boundary
  Stress<dim> traction = {};  ///< stress on a traction boundary at the end of the ramp [Pa]
  StrainRamp ramp = StrainRamp();
  Start start = Start::boundary;
  /// Factor on the load with which the points of the classical formulation really move [-].
  double amplitude = 1e-6;
};

/// Largest time step [s] for which central differences are stable: 2 / omega, with omega^2 the largest eigenvalue of
/// any cell with its share of the lumped mass, an upper bound for the assembled system (Irons and Fried; theory, Eq.
/// 12). The moduli are the unrelaxed ones. Throws InputError when a point has no material, a material no stiffness or
/// no density, or the mass scaling factor is not positive. Instantiated for 2 and 3 dimensions.
template <int dim>
[[nodiscard]] double stable_time_step(const Discretisation<dim>& discretisation, const std::vector<Material>& materials,
                                      Volumetric volumetric, double mass_scaling);

/// Throws InputError when mixed cells have standard volumetric strains, and when the time step of the problem is not
/// positive or above the stable one, naming both. That limit
/// holds for every boundary: a node of a periodic box that stands for several has the mass and the stiffness of them
/// all, and restrained nodes only lower the eigenvalues. Instantiated for 2 and 3 dimensions.
template <int dim>
void require_stable(const DynamicProblem<dim>& problem);

}  // namespace breccia
