#pragma once

#include <map>
#include <string>
#include <vector>

#include "breccia/homogenisation/respond.hpp"
#include "breccia/results/stored_materials.hpp"
#include "breccia/viscoelasticity/material.hpp"

namespace breccia::cli {

/// A temperature other than that of a run.
struct AskedTemperature {
  double kelvin;
  std::string name;       ///< "-40 degC"
  std::string directory;  ///< "respond-minus40degC"
};

/// Reads "-40 degC". Throws InputError.
AskedTemperature read_temperature(const std::string& text);

/// The varying materials of the stages at one temperature, by their names. Throws InputError where one is not known, or
/// not at that temperature.
std::map<std::string, Material> materials_at(const std::vector<StoredMaterial>& materials,
                                             const std::vector<StoredResponses>& stored,
                                             const AskedTemperature& temperature);

}  // namespace breccia::cli
