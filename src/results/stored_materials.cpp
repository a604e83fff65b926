#include "breccia/results/stored_materials.hpp"

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "stored_document.hpp"

namespace breccia {

StoredMaterials read_stored_materials(const std::filesystem::path& directory) {
  const auto document = read_study_document(directory);
  return {document.hash, materials_of(document)};
}

Material at_temperature(const StoredMaterial& stored, double temperature) {
  const auto& [material, shift] = stored;
  if (material.bulk.is_elastic() && material.shear.is_elastic()) return material;
  if (!shift) {
    throw InputError(fmt::format(
        "{} has no temperature_shift in the deck of the study; give the material itself at that temperature",
        material.name));
  }
  const double factor = shift_factor(shift->law, temperature) / shift_factor(shift->law, shift->temperature);
  constexpr double largest = 1e100;
  for (const auto* series : {&material.bulk, &material.shear}) {
    for (const auto& term : series->terms()) {
      const double time = factor * term.relaxation_time;
      if (time > 1.0 / largest && time < largest) continue;
      throw InputError(
          fmt::format("{}: the temperature shift takes a relaxation time of {:.3g} s to {:.3g} s at {} K, which is "
                      "outside its range of use",
                      material.name, term.relaxation_time, time, temperature));
    }
  }
  return shifted(material, factor);
}

}  // namespace breccia
