#pragma once

#include <string>
#include <vector>

#include "breccia/assessment/observation.hpp"
#include "breccia/assessment/unknown.hpp"
#include "breccia/viscoelasticity/shifted_material.hpp"

namespace breccia {

/// An unknown from the text of a command-line option: `hmx.shear` or, with what is known of it,
/// `hmx.shear={ value = "5.84 GPa", sd = "0.6 GPa" }` (read_distribution). The times of a spectrum are given by
/// `binder.spectrum={ from = "1 us", to = "1 s", per_decade = 2 }`; by default two a decade reach one decade beyond the
/// times of the measurements, reduced to the temperature of the study. A number without a distribution is taken as
/// known within a factor 3 of that of the study, the times within a factor 10, constants of a shift law within 1.2,
/// Poisson's ratio as any from 0 to 0.5. `option` begins a line about a mistake. Throws InputError.
Unknown read_unknown(const std::string& text, const std::vector<ShiftedMaterial>& materials,
                     const std::vector<Observation>& observations, const std::string& option);

}  // namespace breccia
