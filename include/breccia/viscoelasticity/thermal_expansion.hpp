#pragma once

#include <complex>
#include <string>
#include <vector>

#include "breccia/viscoelasticity/prony_series.hpp"

namespace breccia {

/// A filler in a matrix whose linear thermal expansion is known.
struct ExpandingFiller {
  double expansion = 0.0;      ///< linear expansion of the filler [1/K]
  double fraction = 0.0;       ///< share of its volume [-]
  PronySeries filler = {};     ///< bulk modulus of the filler [Pa]; zero for voids
  PronySeries matrix = {};     ///< bulk modulus of the matrix [Pa]
  PronySeries composite = {};  ///< bulk modulus of the composite [Pa]
};

/// The linear thermal expansion of a composite of two isotropic phases that are bonded, or of one whose matrix is such
/// a composite: the strain alpha(t) of a free body a time t after its temperature was raised by one kelvin, per kelvin.
/// It follows from the bulk moduli of the phases and of the composite (Levin, Mech. Solids 2, 58, 1967; theory, Eqs.
/// 23g and 23h). That of each phase is constant; the moduli are those at the raised temperature.
class ThermalExpansion {
 public:
  /// Of a homogeneous solid with this expansion [1/K].
  explicit ThermalExpansion(double of_solid) : of_binder_(of_solid) {}

  /// With a filler in what was so far. Throws InputError where the bulk moduli of filler and matrix cross as they
  /// relax, since that of the composite does not determine the expansion there.
  void add(ExpandingFiller filler);

  /// alpha(t) [1/K] at a time [s], t > 0, with an error below 1e-9 of the largest expansion of a phase.
  [[nodiscard]] double at(double time) const;
  /// How far an error of the bulk modulus of the last composite by one hundredth of it, say, moves alpha at a time [s]:
  /// the derivative of alpha by the logarithm of the modulus [1/K], not negative.
  [[nodiscard]] double sensitivity(double time) const;

 private:
  [[nodiscard]] std::complex<double> carson(std::complex<double> s) const;

  double of_binder_;
  std::vector<ExpandingFiller> fillers_;  ///< from the innermost matrix on
};

}  // namespace breccia
