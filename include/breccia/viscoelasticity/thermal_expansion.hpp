#pragma once

#include <complex>
#include <vector>

#include "breccia/viscoelasticity/prony_series.hpp"

namespace breccia {

/// The filler of a composite of two phases, with the bulk moduli that give the thermal expansion.
struct ExpandingFiller {
  double expansion = 0.0;      ///< linear expansion of the filler [1/K]
  PronySeries filler = {};     ///< bulk modulus of the filler, which does not relax [Pa]; zero for voids
  PronySeries matrix = {};     ///< bulk modulus of the matrix [Pa]
  PronySeries composite = {};  ///< bulk modulus of the composite [Pa]
};

/// Whether the bulk modulus of a composite determines its thermal expansion: that of the filler does not relax, and is
/// a tenth and more above that of the matrix at all times, or a tenth and more below it. Otherwise the expansion is a
/// quotient of two small differences, and an error of the modulus may make any number of it.
bool determines_expansion(const PronySeries& filler, const PronySeries& matrix);

/// The linear thermal expansion of a composite of two isotropic phases that are bonded, or of one whose matrix is such
/// a composite: the strain alpha(t) of a free body a time t after its temperature was raised by one kelvin, per kelvin.
/// It follows from the bulk moduli of the phases and of the composite, which is isotropic (Levin, Mech. Solids 2, 58,
/// 1967; theory, Eqs. 23g and 23h). That of each phase is constant; the moduli are those at the raised temperature.
class ThermalExpansion {
 public:
  /// Of a homogeneous solid with this expansion [1/K].
  explicit ThermalExpansion(double of_solid) : of_binder_(of_solid) {}

  /// Makes the solid so far the matrix of a filler. Throws InputError where the bulk moduli do not determine the
  /// expansion (determines_expansion).
  void add(ExpandingFiller filler);

  /// alpha(t) [1/K] at a time [s], t > 0, with an error below 1e-9 of the largest expansion of a phase.
  [[nodiscard]] double at(double time) const;
  /// The absolute derivative of alpha by the logarithm of the bulk modulus of the last composite [1/K], with the moduli
  /// at a time [s].
  [[nodiscard]] double sensitivity(double time) const;

 private:
  [[nodiscard]] std::complex<double> carson(std::complex<double> s) const;

  double of_binder_;
  std::vector<ExpandingFiller> fillers_;  ///< from the innermost matrix on
};

}  // namespace breccia
