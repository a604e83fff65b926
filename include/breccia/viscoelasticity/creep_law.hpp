#pragma once

#include <variant>

namespace breccia {

/// Creep by a power of time: J(t) = J_0 + J_1 (t / t_1)^n.
struct PowerLawCreep {
  double instantaneous;  ///< J_0 [1/Pa], positive
  double creep;          ///< J_1, by which the compliance has grown at t_1 [1/Pa], positive
  double time;           ///< t_1 [s], positive
  double exponent;       ///< n [-], between 0 and 1

  friend bool operator==(const PowerLawCreep&, const PowerLawCreep&) = default;
};

/// Creep by the logarithm of time: J(t) = J_0 + J_1 ln(1 + (t / t_1)^n). With n = 0.1 and t_1 = 1 d it is the basic
/// creep of the model B3 for concrete that no longer ages (Bazant and Baweja, Mater. Struct. 28, 357, 1995).
struct LogarithmicCreep {
  double instantaneous;  ///< J_0 [1/Pa], positive
  double creep;          ///< J_1 [1/Pa], positive
  double time;           ///< t_1 [s], positive
  double exponent;       ///< n [-], above 0 and up to 1

  friend bool operator==(const LogarithmicCreep&, const LogarithmicCreep&) = default;
};

/// A creep compliance given by a formula of few parameters.
using CreepLaw = std::variant<PowerLawCreep, LogarithmicCreep>;

/// Throws InputError when a parameter is out of its range, and names it.
void require_valid(const CreepLaw& law);

/// The compliance at t = 0 [1/Pa].
double instantaneous_compliance(const CreepLaw& law);
/// The characteristic time of a law [s].
double characteristic_time(const CreepLaw& law);

/// Creep compliance [1/Pa] at time t [s], t >= 0.
double compliance_at(const CreepLaw& law, double t);

/// The continuous retardation spectrum L(lambda) [1/Pa] at a retardation time [s]: J(t) = J_0 + integral of L(lambda)
/// (1 - exp(-t / lambda)) d ln lambda (theory, Eq. 23e).
double retardation_spectrum(const CreepLaw& law, double retardation_time);

}  // namespace breccia
