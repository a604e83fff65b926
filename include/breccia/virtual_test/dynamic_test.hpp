#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "breccia/discretisation/boundary.hpp"
#include "breccia/discretisation/load.hpp"
#include "breccia/dynamics/dynamic_solver.hpp"
#include "breccia/virtual_test/curve.hpp"
#include "breccia/virtual_test/virtual_test.hpp"
#include "breccia/viscoelasticity/material.hpp"

namespace breccia {

class Checkpoint;

/// What a dynamic test is made on: relaxation under a displacement or periodic boundary, creep under a traction one.
struct DynamicTest {
  Discretisation<2> discretisation;
  std::vector<Material> materials;  ///< by PhaseIndex
  Boundary boundary = Boundary::displacement;
  Load load = Load::shear;
  TimeWindow times;                      ///< wanted [s]
  int points_per_decade = 20;            ///< of the stitched curve
  std::vector<double> field_times = {};  ///< at which fields are wanted, rising [s]
  DynamicOptions options = {};
  int threads = 0;  ///< 0: all
};

/// One dynamic run with one density factor.
struct TimeDomain {
  double density_factor = 1.0;
  double time_step = 0.0;  ///< [s]
  double ramp = 0.0;       ///< duration of the ramp [s]
  TimeWindow window;       ///< where it is valid [s]
  std::int64_t steps = 0;
  std::size_t terms = 0;         ///< Prony terms with state in the material that has most
  double reduction_error = 0.0;  ///< bound on the relative error of the materials' moduli by leaving out the others [-]
  double seconds = 0.0;          ///< wall time
  /// The modulus from the start of the ramp on, or the reciprocal of the creep compliance, 1 / J(t), from its end on.
  /// Each sample is a mean over a few steps.
  Curve history;

  [[nodiscard]] double point_steps_per_second(std::size_t points) const {
    return static_cast<double>(points) * static_cast<double>(steps) / seconds;
  }
};

/// Where two neighbouring domains are both valid.
struct Overlap {
  TimeWindow window;      ///< [s]
  double mismatch = 0.0;  ///< largest relative difference of the two curves in it [-]
};

struct DynamicTestResult {
  std::vector<TimeDomain> domains;
  std::vector<Overlap> overlaps;
  /// Of a traction boundary: largest relative deviation of the fit through which the compliance became a modulus [-].
  std::optional<double> fit_error = {};
  Curve curve;       ///< relaxation modulus, stitched, at logarithmic times; from creep by interconversion
  Creep compliance;  ///< creep compliance at the same times, stitched, of a traction boundary alone
  std::vector<TimedFields<2>> fields;  ///< at the first sample at or after each of the times wanted
};

/// Where a running test stands.
struct DynamicProgress {
  std::size_t domain = 0;  ///< 0 for the first
  double density_factor = 1.0;
  double time = 0.0;   ///< reached in this domain [s]
  double share = 0.0;  ///< of the whole test, estimated on the logarithmic time axis, 0 to 1
  double point_steps_per_second = 0.0;
};

/// Those who follow a running test. What they throw ends it.
struct DynamicObserver {
  std::function<void(const DynamicProgress&)> progress = {};  ///< now and then
  std::function<void(const TimeDomain&)> finished = {};       ///< each domain, as soon as it is done
};

/// What a test will take, from an estimate of the composite's modulus (ShearModulusBounds).
struct DynamicPlan {
  std::vector<TimeDomain> domains;  ///< without histories and wall times
  std::size_t bytes = 0;            ///< memory of the largest run, about
};
DynamicPlan plan_dynamic_test(const DynamicTest& test);

/// Runs the time domains that the test needs and stitches them. With a checkpoint it leaves its state there when that
/// is due, and goes on from what is there: the same bits as in one go.
/// Throws InputError for an incomplete test, NumericalError when a run is unstable or the times cannot be covered.
DynamicTestResult run_dynamic_test(const DynamicTest& test, const DynamicObserver& observer = {},
                                   Checkpoint* checkpoint = nullptr);

/// Material points x steps per second that a run of this test does on this machine, from a short trial.
double trial_speed(const DynamicTest& test);

/// Mean density of a discretisation [kg/m^3].
double mean_density(const Discretisation<2>& discretisation, const std::vector<Material>& materials);

}  // namespace breccia
