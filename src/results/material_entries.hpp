#pragma once

#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "breccia/viscoelasticity/prony_series.hpp"
#include "breccia/viscoelasticity/temperature_shift.hpp"

#include "results/json_fields.hpp"

namespace breccia {

// The entries for materials in `study.json` (study_document.hpp).

template <>
inline constexpr auto fields<MaxwellTerm> = std::tuple(field("relaxation_time_s", &MaxwellTerm::relaxation_time),
                                                       field("modulus_Pa", &MaxwellTerm::modulus));

/// The parts of a Prony series.
struct SeriesEntry {
  double equilibrium = 0.0;  ///< modulus at equilibrium [Pa]
  std::vector<MaxwellTerm> terms = {};
};
template <>
inline constexpr auto fields<SeriesEntry> = std::tuple(field("equilibrium_Pa", &SeriesEntry::equilibrium),
                                                       field("terms", &SeriesEntry::terms));
template <>
struct JsonForm<PronySeries> {
  static nlohmann::ordered_json write(const PronySeries& series) {
    return json_from(SeriesEntry{series.equilibrium(), series.terms()});
  }
  /// Reads the series. That of a composite in plane strain may have negative moduli, as only a difference of series
  /// can.
  static PronySeries read(const nlohmann::ordered_json& json);
};

/// A law of Williams, Landel and Ferry, or a table.
struct ShiftEntry {
  std::optional<double> c1 = {}, c2 = {};  ///< [-], [K]
  std::optional<std::vector<double>> temperatures = {}, log10_factors = {};
  double reference = 0.0, temperature = 0.0;  ///< [K]
};
template <>
inline constexpr auto fields<ShiftEntry> = std::tuple(field_if_any("c1", &ShiftEntry::c1),
                                                      field_if_any("c2_K", &ShiftEntry::c2),
                                                      field_if_any("temperatures_K", &ShiftEntry::temperatures),
                                                      field_if_any("log10_shift_factors", &ShiftEntry::log10_factors),
                                                      field("reference_K", &ShiftEntry::reference),
                                                      field("temperature_K", &ShiftEntry::temperature));
template <>
struct JsonForm<TemperatureShift> {
  static nlohmann::ordered_json write(const TemperatureShift& shift);
  static TemperatureShift read(const nlohmann::ordered_json& json);
};

struct MaterialEntry {
  std::string name;
  double density = 0.0;  ///< [kg/m^3]
  PronySeries bulk = {}, shear = {};
  std::optional<TemperatureShift> shift = {};
  std::optional<std::vector<double>> constants = {};  ///< of a crystal, as ElasticConstants [Pa]
  std::optional<double> thermal_expansion = {};       ///< linear [1/K]
};
template <>
inline constexpr auto fields<MaterialEntry> =
    std::tuple(field("name", &MaterialEntry::name), field("density_kg_per_m3", &MaterialEntry::density),
               field("bulk", &MaterialEntry::bulk), field("shear", &MaterialEntry::shear),
               field_if_any("temperature_shift", &MaterialEntry::shift),
               field_if_any("elastic_constants_Pa", &MaterialEntry::constants),
               field_if_any("thermal_expansion_1_per_K", &MaterialEntry::thermal_expansion));

}  // namespace breccia
