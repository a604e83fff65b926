#pragma once

#include <complex>
#include <vector>

#include "breccia/homogenisation/study_result.hpp"
#include "breccia/results/frequency_rows.hpp"
#include "breccia/study/test_id.hpp"
#include "breccia/viscoelasticity/prony_series.hpp"

#include "homogenisation/engineering_errors.hpp"

namespace breccia {

/// The moduli of a stage at a time, with those of a uniaxial test (theory, Eqs. 23a and 23b).
struct EngineeringSample {
  double time = 0.0;                ///< [s]
  double shear = 0.0;               ///< G(t) [Pa]
  double bulk = 0.0;                ///< K(t) [Pa]
  double young = 0.0;               ///< E(t) [Pa]
  double poisson = 0.0;             ///< nu(t) [-]
  double tensile_compliance = 0.0;  ///< D(t), the creep compliance in tension [1/Pa]
  EngineeringErrors errors = {};    ///< where the errors of the tests in shear and in bulk are known
};

/// The complex moduli of a stage at an angular frequency.
struct ComplexEngineeringSample {
  double angular_frequency = 0.0;     ///< [rad/s]
  std::complex<double> shear = {};    ///< G' + i G'' [Pa]
  std::complex<double> bulk = {};     ///< K' + i K'' [Pa]
  std::complex<double> young = {};    ///< E' + i E'' [Pa]
  std::complex<double> poisson = {};  ///< nu' + i nu'' [-]
  EngineeringErrors errors = {};      ///< those in time, at the time 1/omega
};

/// The moduli of a stage under one boundary condition.
struct EngineeringCurves {
  TestId test;                                         ///< the test in shear
  std::vector<EngineeringSample> in_time;              ///< samples at the times of this test
  std::vector<ComplexEngineeringSample> in_frequency;  ///< samples at the requested frequencies, rising
  PronySeries shear = {}, bulk = {};                   ///< G(t) and K(t) [Pa]

  /// Adds the complex moduli at an angular frequency [rad/s], with the errors of the nearest time to its inverse.
  void add_frequency(double angular_frequency);
  /// The moduli at a time [s].
  [[nodiscard]] EngineeringSample at_time(double time) const;
  /// The complex moduli at an angular frequency [rad/s].
  [[nodiscard]] ComplexEngineeringSample at(double angular_frequency) const;
};

/// The curves of each boundary condition under which a stage was tested in shear and in bulk by the same method on the
/// same grid, at the times of the curves and at the frequencies of `rows`, from its preferred tests (is_preferred):
/// from the main shear (main_shear).
std::vector<EngineeringCurves> engineering_curves(const StageFindings& stage, const FrequencyRows& rows);

}  // namespace breccia
