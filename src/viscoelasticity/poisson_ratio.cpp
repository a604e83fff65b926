#include "viscoelasticity/poisson_ratio.hpp"

namespace breccia {

double poisson_ratio(double bulk_modulus, double shear_modulus) {
  return (3.0 * bulk_modulus - 2.0 * shear_modulus) / (6.0 * bulk_modulus + 2.0 * shear_modulus);
}

}  // namespace breccia
