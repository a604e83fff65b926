#pragma once

#include <optional>
#include <string>
#include <vector>

#include "breccia/study/stage.hpp"
#include "breccia/viscoelasticity/material.hpp"

namespace breccia {

/// Smallest and largest value of a modulus [Pa].
struct ModulusInterval {
  double least = 0.0;
  double most = 0.0;
};

/// A material whose moduli are not known. The reduced responses of a study hold for every modulus of an elastic
/// material in these intervals, in any combination with the moduli of the phases that relax; a modulus without an
/// interval keeps the value of the material. They hold for a material that relaxes and for all `others` that it may be,
/// too.
struct VariedMaterial {
  std::string name;
  std::optional<ModulusInterval> shear = {};
  std::optional<ModulusInterval> bulk = {};
  std::vector<Material> others = {};  ///< materials that one that relaxes may be, with its name
};

/// The number of moduli that have an interval; a material that may be others counts as one modulus.
int varied_moduli(const std::vector<VariedMaterial>& varied);

/// The mistakes in a varied material of a study with these stages: no stage has it, it has intervals although it
/// relaxes, an interval does not rise or lacks the modulus of the material. One line for each mistake.
std::vector<std::string> mistakes_of_varied(const VariedMaterial& varied, const std::vector<Stage>& stages);

/// Choices of moduli for those of `materials` that vary: on a coarse grid over their intervals, or of all that a
/// material may be. Each element of the result is one choice: all varied materials with their moduli. The first choice
/// is the stiffest, the last one the softest. If no material varies, there is one choice, which is empty.
std::vector<std::vector<Material>> choices_of_varied(const std::vector<VariedMaterial>& varied,
                                                     const std::vector<Material>& materials);

/// The stage with its materials replaced by those of `replacements` that have the same names.
Stage with_materials(Stage stage, const std::vector<Material>& replacements);

}  // namespace breccia
