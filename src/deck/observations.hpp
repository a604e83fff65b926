#pragma once

#include <vector>

#include "breccia/assessment/observation.hpp"
#include "breccia/tables/measured_table.hpp"
#include "breccia/tables/modulus_kind.hpp"

namespace breccia {

/// The measured values of a table as observations of the first composite, without their deviations: a relaxation
/// modulus or a creep compliance over time, or storage and loss moduli over frequency, at one or several temperatures.
/// A modulus whose kind neither the table nor `given` names is one in shear. Throws InputError as measured_data_in(),
/// and for a Prony series, which is a fit.
std::vector<Observation> observations_in(const MeasuredTable& table, ModulusKind given);

}  // namespace breccia
