#pragma once

#include <complex>
#include <variant>

namespace breccia {

/// The 2S2P1D model of bituminous materials, two springs, two parabolic elements and a dashpot (Di Benedetto, Olard,
/// Sauzeat and Delaporte, Road Mater. Pavement Des. 5 (EATA), 163, 2004), at a Laplace variable p:
/// M(p) = M_00 + (M_0 - M_00) / (1 + delta (p tau)^-k + (p tau)^-h + (p beta tau)^-1).
struct TwoSpringsTwoParabolasDashpot {
  double static_modulus;  ///< M_00, after all relaxation [Pa], not negative
  double glassy_modulus;  ///< M_0, before any relaxation [Pa], above the static one
  double delta;           ///< [-], positive
  double time;            ///< tau [s], positive
  double k;               ///< exponent of the faster parabolic element [-], between 0 and h
  double h;               ///< exponent of the slower parabolic element [-], below 1
  double beta;            ///< of the dashpot [-], positive; infinite without one

  friend bool operator==(const TwoSpringsTwoParabolasDashpot&, const TwoSpringsTwoParabolasDashpot&) = default;
};

/// The fractional Zener model (Cole and Cole's form of a relaxation modulus) at a Laplace variable p:
/// M(p) = M_inf + (M_0 - M_inf) (p tau)^alpha / (1 + (p tau)^alpha). Without M_inf it is the fractional Maxwell model
/// of a spring and a springpot in series.
struct FractionalZener {
  double equilibrium;  ///< M_inf [Pa], not negative
  double unrelaxed;    ///< M_0 [Pa], above the equilibrium
  double time;         ///< tau [s], positive
  double exponent;     ///< alpha [-], between 0 and 1

  friend bool operator==(const FractionalZener&, const FractionalZener&) = default;
};

/// A relaxation modulus given by a formula of few parameters in the Laplace domain.
using RelaxationLaw = std::variant<TwoSpringsTwoParabolasDashpot, FractionalZener>;

/// Throws InputError when a parameter is out of its range, and names it.
void require_valid(const RelaxationLaw& law);

/// The modulus before any relaxation, and after all of it [Pa].
double unrelaxed_modulus(const RelaxationLaw& law);
double equilibrium_modulus(const RelaxationLaw& law);
/// The characteristic time of a law [s].
double characteristic_time(const RelaxationLaw& law);

/// The Carson modulus s M~(s) [Pa] at a Laplace variable s [1/s] away from the negative real axis. At s = i omega it is
/// the complex modulus.
std::complex<double> carson_modulus(const RelaxationLaw& law, std::complex<double> s);

/// The continuous relaxation spectrum H(tau) [Pa] at a relaxation time [s]: M(t) = M_inf + integral of H(tau)
/// exp(-t / tau) d ln tau (theory, Eq. 23d).
double relaxation_spectrum(const RelaxationLaw& law, double relaxation_time);

}  // namespace breccia
