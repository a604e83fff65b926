#include "breccia/viscoelasticity/carson_moduli.hpp"

namespace breccia {

std::complex<double> carson_modulus(const PronySeries& series, std::complex<double> s) {
  std::complex<double> sum = series.equilibrium();
  for (const auto& [time, strength] : series.terms()) sum += strength * (s * time) / (1.0 + s * time);
  return sum;
}

ComplexModuli carson_moduli(const Material& material, std::complex<double> s) {
  return {.bulk = carson_modulus(material.bulk, s), .shear = carson_modulus(material.shear, s)};
}

}  // namespace breccia
