// Example 1: a Prony series, and the same viscoelastic solid in its other forms.
//
// The standard linear solid G(t) = 0.2 MPa + 0.8 MPa exp(-t / 1 s) is so simple that its creep compliance is known in
// closed form. A Prony series of any number of terms is used in the same way.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "breccia/viscoelasticity/interconversion.hpp"
#include "breccia/viscoelasticity/prony_series.hpp"

int main() {
  // Everything is in SI units: the equilibrium modulus [Pa], then the relaxation time [s] and the modulus [Pa] of each
  // Maxwell element.
  const breccia::PronySeries relaxation(0.2e6, {{1.0, 0.8e6}});
  const breccia::CreepCompliance creep = breccia::creep_compliance(relaxation);

  fmt::print("Step: relaxation modulus G(t), creep compliance J(t)\n");
  fmt::print("{:>9}  {:>11}  {:>14}  {:>7}\n", "t [s]", "G [MPa]", "J [1/MPa]", "G J [-]");
  for (const double t : {0.0, 0.1, 1.0, 10.0}) {
    const double g = relaxation.at(t), j = creep.at(t);
    fmt::print("{:9.1f}  {:11.4f}  {:14.4f}  {:7.4f}\n", t, g / 1e6, j * 1e6, g * j);
  }

  fmt::print("\nHarmonic strain: storage modulus G', loss modulus G''\n");
  fmt::print("{:>9}  {:>11}  {:>14}  {:>7}\n", "w [rad/s]", "G' [MPa]", "G'' [MPa]", "tan d");
  for (const double omega : {0.1, 1.0, 10.0}) {
    const auto modulus = relaxation.complex_modulus(omega);
    fmt::print("{:9.1f}  {:11.4f}  {:14.4f}  {:7.4f}\n", omega, modulus.real() / 1e6, modulus.imag() / 1e6,
               modulus.imag() / modulus.real());
  }

  // The exact compliance: J(t) = 1/G_inf - (1/G_inf - 1/G_0) exp(-t / lambda) with lambda = (G_0 / G_inf) 1 s.
  double largest_error = 0.0;
  for (double t = 1e-3; t < 1e3; t *= 1.1) {
    const double exact = 1.0 / 0.2e6 - (1.0 / 0.2e6 - 1.0 / 1.0e6) * std::exp(-t / 5.0);
    largest_error = std::max(largest_error, std::abs(creep.at(t) / exact - 1.0));
  }
  // The way back gives the modulus that we began with.
  const double way_back = std::abs(breccia::relaxation_modulus(creep).at(1.0) / relaxation.at(1.0) - 1.0);

  const bool is_right = largest_error < 1e-14 && way_back < 1e-14;
  fmt::print("\nThe compliance agrees with the exact one to rounding: {}\n", is_right ? "yes" : "no");
  return is_right ? 0 : 1;
}
