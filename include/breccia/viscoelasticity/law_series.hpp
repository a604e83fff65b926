#pragma once

#include "breccia/viscoelasticity/creep_law.hpp"
#include "breccia/viscoelasticity/prony_series.hpp"
#include "breccia/viscoelasticity/relaxation_law.hpp"

namespace breccia {

/// A law as a Prony series, its continuous spectrum by the midpoint rule in the logarithm of time (theory, Eq. 23f),
/// with as few terms a decade as the tolerance takes, two for most laws. Over twelve decades on both sides of the
/// characteristic time the complex modulus of a relaxation law is within 0.1 % of the formula, and so is the compliance
/// of a creep law. The modulus before any relaxation and that after all of it are those of the law. Throws InputError
/// when the law is not valid, or when 24 terms a decade do not follow it.
PronySeries series_of(const RelaxationLaw& law);
PronySeries series_of(const CreepLaw& law);

}  // namespace breccia
