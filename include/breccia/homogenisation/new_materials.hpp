#pragma once

#include <optional>
#include <string>

#include "breccia/error.hpp"
#include "breccia/viscoelasticity/material.hpp"
#include "breccia/viscoelasticity/shifted_material.hpp"
#include "breccia/viscoelasticity/temperature_shift.hpp"

namespace breccia {

/// Error: a new material is to replace an elastic material for which the study has sampled no moduli but its own.
class NotVaried : public InputError {
 public:
  using InputError::InputError;
};

/// A new material for a study that has been run. Its name selects what it replaces: a material of the study or a phase
/// of its stages ("matrix", "filler").
struct NewMaterial {
  std::string name;
  Material material;
  std::optional<TemperatureShift> shift = {};  ///< law of its temperature shift, if one is known
};

/// A new material in place of that of a name. Throws InputError for a crystal: stored responses are those of isotropic
/// phases.
[[nodiscard]] NewMaterial new_material(std::string name, ShiftedMaterial given);

}  // namespace breccia
