#pragma once

#include <complex>

#include "breccia/viscoelasticity/material.hpp"

namespace breccia {

/// Moduli of a material at a complex Laplace variable.
struct ComplexModuli {
  std::complex<double> bulk = {};   ///< [Pa]
  std::complex<double> shear = {};  ///< [Pa]
};

/// The Carson modulus s M~(s) = M_inf + sum_k M_k s tau_k / (1 + s tau_k) [Pa] of a series at a Laplace variable
/// s [1/s] away from the negative real axis. At s = i omega it is the complex modulus.
std::complex<double> carson_modulus(const PronySeries& series, std::complex<double> s);

/// Both Carson moduli of a material at a Laplace variable s [1/s] away from the negative real axis.
ComplexModuli carson_moduli(const Material& material, std::complex<double> s);

}  // namespace breccia
