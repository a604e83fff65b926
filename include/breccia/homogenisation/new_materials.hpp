#pragma once

#include <map>
#include <string>
#include <vector>

#include "breccia/error.hpp"
#include "breccia/homogenisation/respond.hpp"
#include "breccia/viscoelasticity/material.hpp"

namespace breccia {

/// Error: a new material is to replace an elastic one, no moduli of which but its own were sampled.
class NotVaried : public InputError {
 public:
  using InputError::InputError;
};

/// A new material for a study that has been run, and what it is to replace: a material of the study or a phase of its
/// stages ("matrix", "filler"), by name.
struct NewMaterial {
  std::string name;
  Material material;
};

/// The new materials by the names of the materials of the study that they replace, as respond() takes them.
/// `of_study` are the materials of the study, as far as they are known. Throws InputError, with one line for each
/// mistake: a name that is none of a material or a phase that varies, a phase that is of several materials, a material
/// that is replaced twice; this error is NotVaried if a material or phase is elastic and was not sampled.
std::map<std::string, Material> by_replaced_material(const std::vector<NewMaterial>& new_materials,
                                                     const std::vector<StoredResponses>& stored,
                                                     const std::vector<Material>& of_study);

/// The names of the materials that the stages have as matrix, and of those of their other phases whose moduli vary.
std::vector<std::string> varying_materials(const std::vector<StoredResponses>& stored);

}  // namespace breccia
