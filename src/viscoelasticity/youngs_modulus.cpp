#include "viscoelasticity/youngs_modulus.hpp"

namespace breccia {

double youngs_modulus(double bulk_modulus, double shear_modulus) {
  const double sum = 3.0 * bulk_modulus + shear_modulus;
  return sum > 0.0 ? 9.0 * bulk_modulus * shear_modulus / sum : 0.0;
}

}  // namespace breccia
