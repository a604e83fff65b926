#pragma once

#include <map>
#include <string>
#include <vector>

#include "breccia/deck/material_file.hpp"
#include "breccia/deckfile/deck.hpp"
#include "breccia/viscoelasticity/material.hpp"
#include "breccia/viscoelasticity/temperature_shift.hpp"

namespace breccia {

/// The materials of a deck, and their temperature shifts by the names of the materials.
struct DeckMaterials {
  std::vector<Material> materials;
  std::map<std::string, TemperatureShift> temperature_shifts;
};

/// Reads [materials]: each table is a material, named by its key.
DeckMaterials read_materials(const Section& deck);

/// Reads one material.
ShiftedMaterial read_shifted_material(const Section& section, const std::string& name);

/// The material that a key names; a material without a name after a mistake was reported.
Material read_material_reference(const Section& section, const std::string& key,
                                 const std::vector<Material>& materials);

}  // namespace breccia
