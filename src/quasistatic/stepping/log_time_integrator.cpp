#include "quasistatic/stepping/log_time_integrator.hpp"

namespace breccia::quasistatic {

double mean_decay(double x) {
  return x > 0.0 ? -std::expm1(-x) / x : 1.0;
}

double algorithmic_modulus(const PronySeries& series, double step) {
  double modulus = series.equilibrium();
  for (const auto& [time, strength] : series.terms()) modulus += strength * mean_decay(step / time);
  return modulus;
}

}  // namespace breccia::quasistatic
