#pragma once

namespace breccia {

/// Young's modulus 9 K G / (3 K + G) [Pa] of a solid with these bulk and shear moduli [Pa]; zero where both are zero.
double youngs_modulus(double bulk_modulus, double shear_modulus);

}  // namespace breccia
