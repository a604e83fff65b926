#include "breccia/viscoelasticity/prony_series.hpp"

/// The program succeeds if the binder of the model composite has relaxed to half its modulus after ln 2 relaxation
/// times.
int main() {
  const breccia::PronySeries shear(0.0, {{0.01, 0.5e6}});
  const double error = shear.at(0.01 * 0.69314718055994531) - 0.25e6;
  return error < 1e-6 && error > -1e-6 ? 0 : 1;
}
