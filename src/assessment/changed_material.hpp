#pragma once

#include <map>
#include <optional>
#include <vector>

#include "breccia/assessment/unknown.hpp"
#include "breccia/viscoelasticity/shifted_material.hpp"

namespace breccia {

/// New values of what describes a material.
struct MaterialChange {
  std::map<MaterialNumber, double> numbers = {};             ///< in SI units
  std::optional<std::vector<MaxwellTerm>> shear_terms = {};  ///< of a new spectrum

  [[nodiscard]] bool has(MaterialNumber number) const { return numbers.contains(number); }
};

/// The material with a change (MaterialNumber). Throws InputError where the change has no meaning for the material: an
/// elastic constant of one that relaxes, times of one that does not, a law that it does not have, three elastic
/// constants, two of them that no solid has.
ShiftedMaterial changed(const ShiftedMaterial& material, const MaterialChange& change);

/// Whether Poisson's ratio of a material that relaxes does not depend on time.
bool has_constant_poisson_ratio(const Material& material);

}  // namespace breccia
