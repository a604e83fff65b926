#pragma once

#include <complex>
#include <span>
#include <vector>

#include "breccia/quasistatic/reduced_response.hpp"
#include "breccia/viscoelasticity/carson_moduli.hpp"

namespace breccia {

/// A value of a composite at a complex Laplace variable, and its derivatives with respect to the moduli of the phases
/// that vary.
struct ValueAndGradient {
  std::complex<double> value = 0.0;
  /// Derivatives with respect to the bulk and the shear modulus of each phase, in the order of
  /// ReducedResponse::phases().
  std::vector<ComplexModuli> gradient;
};

/// The compliance C = e' K^-1 e [1/Pa] of a reduced response at moduli [Pa] of its phases, and its gradient [1/Pa^2].
/// With c = K^-1 e the derivatives are dC/dp_i = -c' K_i c: they need no further solution (theory, Eq. 18b). Throws
/// InputError when the numbers of moduli and of varying phases differ, NumericalError where K is singular.
ValueAndGradient compliance_and_gradient(const ReducedResponse& response, std::span<const ComplexModuli> of_phases);

/// The modulus M = 1/C [Pa] in place of the compliance, with the derivatives dM/dp_i = M^2 c' K_i c [-].
ValueAndGradient modulus_and_gradient(const ReducedResponse& response, std::span<const ComplexModuli> of_phases);

}  // namespace breccia
