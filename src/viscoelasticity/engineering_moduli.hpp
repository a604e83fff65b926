#pragma once

#include <complex>

#include "breccia/viscoelasticity/prony_series.hpp"

namespace breccia {

/// Young's modulus and Poisson's ratio of a linear viscoelastic solid in uniaxial tests, from its shear and bulk moduli
/// by the correspondence principle (theory, Eqs. 23a and 23b). The bulk modulus may be a difference of series
/// (PronySeries::difference), as of a composite in plane strain.
class EngineeringModuli {
 public:
  EngineeringModuli(PronySeries shear, PronySeries bulk);

  /// Relaxation modulus E(t) [Pa] after a step of the axial strain at time t [s], t > 0: the inverse Laplace transform
  /// by a contour of Talbot (Abate and Valko, Int. J. Numer. Methods Eng. 60, 979, 2004), with a relative error below
  /// 1e-9.
  [[nodiscard]] double youngs_modulus(double t) const;
  /// Creep compliance in tension D(t) [1/Pa], the axial strain after a step of the axial stress, at time t [s], t > 0,
  /// with a relative error below 1e-9.
  [[nodiscard]] double tensile_compliance(double t) const;
  /// Ratio of lateral contraction at time t [s], t > 0, and axial strain after a step of the axial strain [-], with an
  /// error below 1e-9.
  [[nodiscard]] double poisson_ratio(double t) const;
  /// The complex Young's modulus E' + i E'' [Pa] at angular frequency omega [rad/s].
  [[nodiscard]] std::complex<double> complex_youngs_modulus(double omega) const;
  /// The complex Poisson's ratio nu' + i nu'' [-] at angular frequency omega [rad/s]; the imaginary part is negative
  /// where the contraction lags behind.
  [[nodiscard]] std::complex<double> complex_poisson_ratio(double omega) const;

 private:
  PronySeries shear_;
  PronySeries bulk_;
};

}  // namespace breccia
