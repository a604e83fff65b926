#pragma once

#include "breccia/tables/measured_table.hpp"
#include "breccia/tables/modulus_kind.hpp"

#include "deck/fit_data.hpp"
#include "tables/complex_modulus.hpp"

namespace breccia {

/// The frequency sweeps in a table of dynamic moduli, by rising temperature. Rows whose temperatures follow each other
/// within 0.5 K, the scatter of a test chamber, are one sweep. A table in which the temperature changes steadily is a
/// ramp (sweeps_of_ramp()). Throws InputError with all rows that are not positive or repeat a frequency.
DynamicData frequency_sweeps(const MeasuredTable& table, const ComplexModulusColumns& columns, ModulusKind kind);

}  // namespace breccia
