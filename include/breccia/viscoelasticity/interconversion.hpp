#pragma once

#include "breccia/viscoelasticity/creep_compliance.hpp"
#include "breccia/viscoelasticity/prony_series.hpp"

namespace breccia {

/// The creep compliance of a solid with this relaxation modulus. The conversion is exact: there is one retardation time
/// between each two neighbouring relaxation times (theory, Eqs. 22 and 23; Park and Schapery, Int. J. Solids Struct.
/// 36, 1653, 1999). Without an equilibrium modulus the material flows (its fluidity is positive). Every time and
/// strength has full relative precision, however wide the spectrum is. Throws InputError when the modulus is zero.
CreepCompliance creep_compliance(const PronySeries& modulus);

/// The relaxation modulus of a solid with this creep compliance; the inverse of creep_compliance().
PronySeries relaxation_modulus(const CreepCompliance& compliance);

}  // namespace breccia
