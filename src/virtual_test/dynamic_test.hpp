#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "breccia/discretisation/boundary.hpp"
#include "breccia/discretisation/load.hpp"
#include "breccia/progress.hpp"
#include "breccia/virtual_test/curve.hpp"
#include "breccia/virtual_test/dynamic_options.hpp"
#include "breccia/virtual_test/test_fields.hpp"
#include "breccia/virtual_test/time_domain.hpp"
#include "breccia/viscoelasticity/material.hpp"

#include "dynamics/dynamic_solver.hpp"

namespace breccia {

class Checkpoint;

/// A dynamic virtual test: relaxation under a displacement or periodic boundary, creep under a traction boundary.
template <int dim>
struct DynamicTest {
  Discretisation<dim> discretisation;
  std::vector<Material> materials;  ///< materials by PhaseIndex
  Volumetric volumetric = Volumetric::averaged;
  Boundary boundary = Boundary::displacement;
  Load load = Load::shear;
  TimeWindow times;                      ///< times of the curve [s]
  int points_per_decade = 20;            ///< samples per decade of the stitched curve
  std::vector<double> field_times = {};  ///< rising times at which fields are wanted [s]
  DynamicOptions options = {};
  int threads = 0;  ///< number of threads; 0: all cores
};

/// The result of a dynamic test.
struct DynamicTestResult {
  std::vector<TimeDomain> domains;
  std::vector<Overlap> overlaps;  ///< overlaps of neighbouring domains, in the order of the domains
  /// Largest relative deviation of the fit by which the compliance is converted; under a traction boundary only [-].
  std::optional<double> fit_error = {};
  Curve curve;       ///< stitched relaxation modulus at logarithmic times; under a traction boundary by interconversion
  Creep compliance;  ///< stitched creep compliance at the same times, under a traction boundary only
  /// Fields at each field time: the state after the steps whose mean is the first sample at or after that time.
  TestFields fields;
};

/// Is called with each time domain that is finished. An exception that it throws ends the test.
using DomainObserver = std::function<void(const TimeDomain&)>;

/// Plans the time domains of a test, without histories and wall times, by an estimate of the composite's modulus
/// (ShearModulusBounds). Throws the errors of run_dynamic_test(). The plan holds for the test with `refinement` times
/// as many cells along each axis, so that a large grid is planned by means of a small one in little time and memory.
/// Instantiated, as the functions below, for 2 and 3 dimensions.
template <int dim>
std::vector<TimeDomain> plan_dynamic_test(const DynamicTest<dim>& test, double refinement = 1.0);

/// Approximate memory [B] of the largest of the runs that a test may need, whichever time domains it has.
template <int dim>
double dynamic_memory(const DynamicTest<dim>& test, double refinement = 1.0);

/// Runs the time domains that the test needs and stitches their curves. The share of the progress is estimated on the
/// logarithmic time axis. With a checkpoint, the state is saved when that is due, and an earlier state is resumed, with
/// results that are bitwise identical to those of one run. Throws InputError for an incomplete test or a load that does
/// not exist in this number of dimensions, NumericalError when a run is unstable or the times cannot be covered.
template <int dim>
DynamicTestResult run_dynamic_test(const DynamicTest<dim>& test, const ProgressObserver& observer = {},
                                   const DomainObserver& finished = {}, Checkpoint* checkpoint = nullptr);

/// Speed of this test on this machine in material points x steps per second [1/s], from a short trial.
template <int dim>
double trial_speed(const DynamicTest<dim>& test);

/// Mean density of a discretisation [kg/m^3].
template <int dim>
double mean_density(const Discretisation<dim>& discretisation, const std::vector<Material>& materials);

}  // namespace breccia
