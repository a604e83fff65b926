#include "virtual_test/bulk_test.hpp"

namespace breccia {

double shear_in_bulk_test(int dimensions) {
  return is_plane_strain(dimensions) ? 1.0 / 3.0 : 0.0;
}

PronySeries bulk_modulus_of(const PronySeries& bulk_test, const PronySeries& shear, int dimensions) {
  if (!is_plane_strain(dimensions)) return bulk_test;
  return PronySeries::difference(bulk_test, shear.scaled(shear_in_bulk_test(dimensions)));
}

std::string_view symbol_of_bulk_test(int dimensions) {
  return is_plane_strain(dimensions) ? "K + G/3" : "K";
}

std::string_view formula_of_bulk_test(int dimensions) {
  return is_plane_strain(dimensions) ? "K(t) + G(t)/3" : "K(t)";
}

}  // namespace breccia
