#include "breccia/results/stored_materials.hpp"

#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "breccia/error.hpp"
#include "breccia/io/text_file.hpp"

namespace breccia {
namespace {

PronySeries series_of(const nlohmann::json& json) {
  std::vector<MaxwellTerm> terms;
  for (const auto& term : json.at("terms")) {
    terms.push_back({term.at("relaxation_time_s").get<double>(), term.at("modulus_Pa").get<double>()});
  }
  return {json.at("equilibrium_Pa").get<double>(), std::move(terms)};
}

TemperatureShift shift_of(const nlohmann::json& json) {
  const auto reference = json.at("reference_K").get<double>(), temperature = json.at("temperature_K").get<double>();
  if (json.contains("log10_shift_factors")) {
    return {ShiftTable(json.at("temperatures_K").get<std::vector<double>>(),
                       json.at("log10_shift_factors").get<std::vector<double>>(), reference),
            temperature};
  }
  return {WilliamsLandelFerry{json.at("c1").get<double>(), json.at("c2_K").get<double>(), reference}, temperature};
}

StoredMaterial material_of(const nlohmann::json& json) {
  StoredMaterial stored{{json.at("name").get<std::string>(), json.at("density_kg_per_m3").get<double>(),
                         series_of(json.at("bulk")), series_of(json.at("shear"))}};
  if (json.contains("temperature_shift")) stored.shift = shift_of(json.at("temperature_shift"));
  return stored;
}

}  // namespace

StoredMaterials read_stored_materials(const std::filesystem::path& directory) {
  const auto file = directory / "study.json";
  const auto refuse = [&](const std::string& reason) {
    throw FileError(fmt::format("{}: not as `breccia run` writes it{}", file.string(), reason));
  };
  StoredMaterials stored;
  const auto json = nlohmann::json::parse(read_text(file), nullptr, false);
  if (!json.is_object()) refuse("");
  try {
    stored.deck_hash = json.at("hash").get<std::string>();
    for (const auto& material : json.at("materials")) stored.materials.push_back(material_of(material));
  } catch (const nlohmann::json::exception& error) {
    refuse(fmt::format(": {}", error.what()));
  } catch (const InputError& error) {
    refuse(fmt::format(": {}", error.what()));
  }
  return stored;
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
