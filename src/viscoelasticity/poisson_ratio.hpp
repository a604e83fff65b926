#pragma once

namespace breccia {

/// Poisson's ratio (3 K - 2 G) / (6 K + 2 G) of a solid with these bulk and shear moduli [Pa]; not a number where both
/// are zero.
double poisson_ratio(double bulk_modulus, double shear_modulus);

}  // namespace breccia
