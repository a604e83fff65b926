#include "deck/moduli.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/tables/modulus_kind.hpp"

#include "deck/fitted_modulus.hpp"
#include "deck/laws.hpp"
#include "deck/prony_file.hpp"
#include "study/limits.hpp"
#include "viscoelasticity/two_moduli.hpp"

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

/// Reads the moduli of one material.
class ModuliReader {
 public:
  DeckModuli read(const Section& material);

 private:
  PronySeries read_measured_modulus(const Section& modulus, ModulusKind kind);
  PronySeries read_series(const Section& modulus, ModulusKind kind);
  PronySeries read_modulus(const Section& material, const std::string& key, ModulusKind kind);
  std::optional<BulkAndShear> read_pair(const Section& material);

  std::vector<ShiftLaw> measured_laws_;  ///< shift laws of the moduli that have been read
};

/// `{ measured = "file.csv", reference_temperature = "19 degC" }`: a series fitted to data.
PronySeries ModuliReader::read_measured_modulus(const Section& modulus, ModulusKind kind) {
  PronySeries series;
  const auto path = modulus.file("measured");
  const auto temperature =
      modulus.optional_quantity("reference_temperature", Dimension::temperature, Range::not_negative());
  modulus.refuse({"equilibrium"}, "the fit of measured data finds it");
  if (path.empty() || (temperature && std::isnan(*temperature))) return series;
  modulus.report_errors_of("measured", [&] {
    auto fitted = fitted_modulus(path, kind, temperature);
    series = std::move(fitted.series);
    for (const auto& remark : remarks_on(fitted, path, kind)) modulus.remark("measured", remark);
    if (fitted.shift_law) measured_laws_.push_back(*std::move(fitted.shift_law));
  });
  return series;
}

/// `{ prony = "file.csv" }`, `{ measured = "file.csv" }`, `{ law = "2s2p1d", ... }` or
/// `{ equilibrium = "1 MPa", terms = [...] }`.
PronySeries ModuliReader::read_series(const Section& modulus, ModulusKind kind) {
  PronyFile spectrum;
  bool is_known = false;
  const auto source = modulus.exactly_one({"prony", "terms", "measured", "law"});
  if (source == "measured") return read_measured_modulus(modulus, kind);
  if (source == "law") return read_law(modulus);
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

PronySeries ModuliReader::read_modulus(const Section& material, const std::string& key, ModulusKind kind) {
  if (material.kind(key) != Kind::table || material.is_distribution(key)) {
    const double modulus = material.quantity(key, Dimension::pressure, Range::positive());
    return std::isnan(modulus) ? PronySeries() : PronySeries(modulus);
  }
  return read_series(material.section(key), kind);
}

/// The moduli that two of `bulk`, `shear`, `young` and `poisson` determine; nothing after a mistake. A material without
/// the last two keys lacks one of the first two.
std::optional<BulkAndShear> ModuliReader::read_pair(const Section& material) {
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
    moduli.poisson = material.number("poisson", allowed::poisson);
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

DeckModuli ModuliReader::read(const Section& material) {
  DeckModuli moduli;
  if (auto pair = read_pair(material)) {
    moduli.bulk = std::move(pair->bulk);
    moduli.shear = std::move(pair->shear);
  }
  // Two measured moduli need a law in the deck.
  if (measured_laws_.size() == 1) moduli.shift_law = measured_laws_.front();
  return moduli;
}

}  // namespace

DeckModuli read_moduli(const Section& material) {
  return ModuliReader().read(material);
}

}  // namespace breccia
