#pragma once

#include <vector>

#include "breccia/assessment/observation.hpp"
#include "breccia/tables/measured_table.hpp"
#include "breccia/tables/modulus_kind.hpp"

namespace breccia {

/// The measured values of a table as observations of the first composite, without their deviations.
struct ReadObservations {
  std::vector<Observation> observations;
  ModulusKind kind;  ///< kind of modulus; one in shear is taken where neither the table nor the user names it
};

/// Reads a relaxation modulus or a creep compliance over time, or storage and loss moduli over frequency, at one or
/// several temperatures. Throws InputError as measured_data_in(), for a Prony series, which is a fit, for a temperature
/// that changes through the measurement, and for temperatures beside a curve over time.
ReadObservations observations_in(const MeasuredTable& table, ModulusKind given);

}  // namespace breccia
