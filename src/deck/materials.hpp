#pragma once

#include <string>
#include <vector>

#include "breccia/viscoelasticity/shifted_material.hpp"

#include "deckfile/deck.hpp"

namespace breccia {

/// Reads [materials]: each table is a material, named by its key.
std::vector<ShiftedMaterial> read_materials(const Section& deck);

/// Reads one material.
ShiftedMaterial read_shifted_material(const Section& section, const std::string& name);

/// Reports that a key names a crystal where an isotropic material is expected, with the means that could take its
/// place.
void refuse_crystal(const Section& section, const std::string& key, const Material& means);

/// The isotropic material that a key names; a material without a name after a mistake was reported.
Material read_material_reference(const Section& section, const std::string& key,
                                 const std::vector<ShiftedMaterial>& materials);

}  // namespace breccia
