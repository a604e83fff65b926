#include "materials.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/deck/prony_file.hpp"
#include "breccia/io/nearest_name.hpp"
#include "breccia/io/printable.hpp"
#include "breccia/viscoelasticity/temperature_shift.hpp"

#include "fitted_modulus.hpp"
#include "temperature_shift.hpp"
#include "two_moduli.hpp"

namespace breccia {

namespace {

std::vector<MaxwellTerm> read_terms(const Section& modulus) {
  std::vector<MaxwellTerm> terms;
  for (const auto& term : modulus.sections("terms")) {
    terms.push_back({term.quantity("time", Dimension::time, Range::positive()),
                     term.quantity("modulus", Dimension::pressure, Range::not_negative())});
  }
  return terms;
}

/// Whether a shift would make a relaxation time zero or infinite.
bool is_out_of_scale(const MaxwellTerm& term) {
  constexpr double largest = 1e100;
  return term.relaxation_time < 1.0 / largest || term.relaxation_time > largest;
}

/// `{ measured = "file.csv", reference_temperature = "19 degC" }`: a series fitted to data.
PronySeries read_measured_modulus(const Section& modulus, ModulusKind kind) {
  PronySeries series;
  const auto path = modulus.file("measured");
  const auto temperature =
      modulus.optional_quantity("reference_temperature", Dimension::temperature, Range::not_negative());
  modulus.refuse({"equilibrium"}, "the fit of measured data finds it");
  if (path.empty() || (temperature && std::isnan(*temperature))) return series;
  modulus.report_errors_of("measured", [&] { series = fitted_modulus(path, kind, temperature).series; });
  return series;
}

/// `{ prony = "file.csv" }`, `{ measured = "file.csv" }` or `{ equilibrium = "1 MPa", terms = [...] }`.
PronySeries read_series(const Section& modulus, ModulusKind kind) {
  PronyFile spectrum;
  bool is_known = false;
  const auto source = modulus.exactly_one({"prony", "terms", "measured"});
  if (source == "measured") return read_measured_modulus(modulus, kind);
  if (source == "prony") {
    const auto path = modulus.file("prony");
    if (!path.empty())
      modulus.report_errors_of("prony", [&] {
        spectrum = read_prony_file(path, kind);
        is_known = true;
      });
  } else if (source == "terms") {
    spectrum.terms = read_terms(modulus);
    is_known = true;
  }
  const auto equilibrium = modulus.optional_quantity("equilibrium", Dimension::pressure, Range::not_negative());
  if (equilibrium && spectrum.equilibrium) {
    modulus.report("equilibrium", "the file has an equilibrium modulus already (relaxation time inf)");
  }
  PronySeries series;
  const bool complete = std::ranges::none_of(spectrum.terms, [](const MaxwellTerm& term) {
    return std::isnan(term.relaxation_time) || std::isnan(term.modulus);
  });
  if (!complete) return series;
  series = PronySeries(equilibrium.value_or(spectrum.equilibrium.value_or(0.0)), spectrum.terms);
  const bool is_positive = series.unrelaxed() > 0.0 && std::isfinite(series.unrelaxed());
  if (is_known && !is_positive) modulus.report(source, "expected a modulus above zero, and finite");
  if (std::ranges::any_of(series.terms(), is_out_of_scale)) {
    modulus.report(source, "expected relaxation times between 1e-100 s and 1e100 s");
  }
  return series;
}

PronySeries read_modulus(const Section& material, const std::string& key, ModulusKind kind) {
  if (material.kind(key) != Kind::table) {
    const double modulus = material.quantity(key, Dimension::pressure, Range::positive());
    return std::isnan(modulus) ? PronySeries() : PronySeries(modulus);
  }
  return read_series(material.section(key), kind);
}

/// The moduli that two of `bulk`, `shear`, `young` and `poisson` determine; nothing after a mistake. A material without
/// the last two keys lacks one of the first two.
std::optional<BulkAndShear> read_moduli(const Section& material) {
  if (!material.has("young") && !material.has("poisson")) {
    return BulkAndShear{read_modulus(material, "bulk", ModulusKind::bulk),
                        read_modulus(material, "shear", ModulusKind::shear)};
  }
  std::vector<std::string> given;
  for (const auto* key : {"bulk", "shear", "young", "poisson"}) {
    if (material.has(key)) given.emplace_back(key);
  }
  TwoModuli moduli;
  bool is_complete = true;
  const auto read = [&](const std::string& key, ModulusKind kind, std::optional<PronySeries>& modulus) {
    if (std::ranges::find(given, key) == given.end()) return;
    modulus = read_modulus(material, key, kind);
    is_complete = is_complete && modulus->unrelaxed() > 0.0;
  };
  read("bulk", ModulusKind::bulk, moduli.bulk);
  read("shear", ModulusKind::shear, moduli.shear);
  read("young", ModulusKind::young, moduli.young);
  if (material.has("poisson")) {
    moduli.poisson = material.number("poisson", Range::between(-1.0, 0.5));
    is_complete = is_complete && !std::isnan(*moduli.poisson);
  }
  if (given.size() != 2) {
    const auto expected = std::string("expected two of bulk, shear, young and poisson");
    material.report(given.size() > 2 ? given.back() : "",
                    fmt::format("{}, got {}", expected, fmt::join(given, " and ")));
    return std::nullopt;
  }
  std::optional<BulkAndShear> found;
  if (!is_complete) return found;
  material.report_errors_of(given.back(), [&] { found = bulk_and_shear(moduli); });
  return found;
}

}  // namespace

ShiftedMaterial read_shifted_material(const Section& section, const std::string& name) {
  Material reference = {name, section.quantity("density", Dimension::density, Range::positive()), {}, {}};
  if (const auto moduli = read_moduli(section)) {
    reference.bulk = moduli->bulk;
    reference.shear = moduli->shear;
  }
  const auto shift = read_temperature_shift(section);
  return {shift ? shifted(reference, shift_factor(shift->law, shift->temperature)) : reference, shift};
}

DeckMaterials read_materials(const Section& deck) {
  const auto section = deck.section("materials");
  DeckMaterials read;
  for (const auto& name : section.keys()) {
    if (!is_printable(name)) section.report(name, "expected a name without line breaks and other control characters");
    const auto material = section.section(name);
    auto [shifted, shift] = read_shifted_material(material, name);
    read.materials.push_back(std::move(shifted));
    if (shift) read.temperature_shifts.emplace(name, *shift);
  }
  return read;
}

Material read_material_reference(const Section& section, const std::string& key,
                                 const std::vector<Material>& materials) {
  const auto name = section.text(key);
  if (name.empty()) return {};
  const auto material = std::ranges::find(materials, name, &Material::name);
  if (material != materials.end()) return *material;
  std::vector<std::string> names;
  names.reserve(materials.size());
  for (const auto& known : materials) names.push_back(known.name);
  section.report(key, fmt::format("unknown material \"{}\"{}", name, suggestion(name, names)));
  return {};
}

}  // namespace breccia
