#pragma once

#include "breccia/viscoelasticity/creep_law.hpp"
#include "breccia/viscoelasticity/prony_series.hpp"
#include "breccia/viscoelasticity/relaxation_law.hpp"

namespace breccia {

/// A law as a Prony series: its continuous spectrum by the midpoint rule in the logarithm of time (theory, Eq. 23f).
struct LawSeries {
  PronySeries series;
  /// Largest relative deviation from the law, from `first` to `last`: of the complex modulus at angular frequencies 1/t
  /// of a relaxation law, of the compliance at times t of a creep law [-].
  double error = 0.0;
  double first = 0.0;  ///< [s]
  double last = 0.0;   ///< [s]
};

/// The Prony series of a law, within 0.1 % over twelve decades on both sides of its characteristic time, with as few
/// terms a decade as that takes: two for most laws. The modulus after all relaxation is that of the law. Throws
/// InputError when the law is not valid, or when its spectrum is too narrow for 24 terms a decade.
LawSeries series_of(const RelaxationLaw& law);
LawSeries series_of(const CreepLaw& law);

}  // namespace breccia
