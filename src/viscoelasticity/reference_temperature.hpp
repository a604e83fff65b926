#pragma once

#include "breccia/viscoelasticity/temperature_shift.hpp"

namespace breccia {

/// The law with another reference temperature [K]: the product c1 c2 and c2 - T_ref do not change (theory, Eq. 28a;
/// Ferry, Viscoelastic Properties of Polymers, chapter 11). Throws InputError at or below T_ref - c2.
WilliamsLandelFerry with_reference(const WilliamsLandelFerry& law, double temperature);

/// The table of shift factors with another reference temperature [K]. Throws InputError outside the table.
ShiftTable with_reference(const ShiftTable& table, double temperature);

}  // namespace breccia
