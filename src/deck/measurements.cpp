#include "deck/measurements.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/tables/measured_table_reader.hpp"

#include "deck/fitted_modulus.hpp"
#include "deck/laws.hpp"
#include "deck/prony_file.hpp"
#include "deck/time_window.hpp"
#include "io/file_mistakes.hpp"
#include "io/nearest_name.hpp"
#include "io/units.hpp"
#include "study/chain.hpp"

namespace breccia {
namespace {

PronySeries read_measured_series(const std::filesystem::path& path, ModulusKind kind) {
  auto [equilibrium, terms] = read_prony_file(path, kind);
  PronySeries series(equilibrium.value_or(0.0), std::move(terms));
  if (!accepts(Range::positive(), series.unrelaxed())) {
    throw InputError(fmt::format("{}: expected a modulus above zero, and finite", path.string()));
  }
  return series;
}

Curve read_measured_curve(const std::filesystem::path& path, ModulusKind kind) {
  const auto table = read_measured_table(path);
  table.require({Quantity::time, Quantity::modulus});
  table.refuse_several_series();
  const auto& times = table.column(Quantity::time);
  const auto& moduli = table.column(Quantity::modulus, kind);
  FileMistakes mistakes(path);
  Curve curve;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double time = times.values[row], modulus = moduli.values[row];
    const double earlier = curve.empty() ? 0.0 : curve.back().time;
    if (!(time > earlier) || !std::isfinite(time)) {
      mistakes.add(table.location(row), "expected rising positive times", fmt::format("{}", times.written[row]));
    } else if (!(modulus > 0.0) || !std::isfinite(modulus)) {
      mistakes.add(table.location(row), "expected a positive modulus", fmt::format("{}", moduli.written[row]));
    } else {
      curve.push_back({time, modulus});
    }
  }
  constexpr std::size_t fewest = 2;
  if (mistakes.empty() && curve.size() < fewest) mistakes.add("", fmt::format("expected at least {} rows", fewest));
  mistakes.refuse();
  return curve;
}

/// Makes a remark on each material at another temperature [K] than that of a measured modulus.
void remark_on_temperatures(const Section& modulus, double measured, const std::vector<ShiftedMaterial>& materials) {
  constexpr double least_difference = 0.5;  // as of a sweep that is taken for one at the reference temperature [K]
  for (const auto& one : materials) {
    if (!one.shift || std::abs(one.shift->temperature - measured) <= least_difference) continue;
    modulus.remark("reference_temperature", fmt::format("the measured modulus is at {}, and {} is at {}",
                                                        readable(measured, Dimension::temperature), one.material.name,
                                                        readable(one.shift->temperature, Dimension::temperature)));
  }
}

/// Reads creep, dynamic or relaxation data and fits a series to them, which is valid at the times of the data.
void read_fitted(const Section& modulus, const std::filesystem::path& path,
                 const std::vector<ShiftedMaterial>& materials, Measurement& measurement) {
  const auto temperature =
      modulus.optional_quantity("reference_temperature", Dimension::temperature, Range::not_negative());
  if (temperature && std::isnan(*temperature)) return;
  if (temperature) remark_on_temperatures(modulus, *temperature, materials);
  modulus.report_errors_of("measured", [&] {
    auto fitted = fitted_modulus(path, measurement.kind, temperature);
    measurement.modulus = std::move(fitted.series);
    measurement.times = fitted.measured_times;
    measurement.dynamic = std::move(fitted.dynamic);
    for (const auto& remark : remarks_on(fitted, path, measurement.kind)) modulus.remark("measured", remark);
  });
}

/// Reads the measured modulus of the kind of a measurement.
void read_measured_modulus(const Section& modulus, const std::vector<ShiftedMaterial>& materials,
                           Measurement& measurement) {
  const auto source = modulus.exactly_one({"prony", "curve", "measured", "law"});
  if (source.empty()) return;
  if (source == "law") {
    measurement.modulus = read_law(modulus);
    return;
  }
  const auto path = modulus.file(source);
  if (path.empty()) return;
  if (source == "measured") return read_fitted(modulus, path, materials, measurement);
  modulus.report_errors_of(source, [&] {
    if (source == "prony") {
      measurement.modulus = read_measured_series(path, measurement.kind);
    } else {
      measurement.modulus = read_measured_curve(path, measurement.kind);
    }
  });
}

std::string read_stage(const Section& section, const std::vector<Stage>& stages) {
  if (!section.has("stage")) return stages.empty() ? "" : stages.back().name;
  auto name = section.text("stage");
  std::vector<std::string> names;
  std::ranges::transform(stages, std::back_inserter(names), &Stage::name);
  if (!name.empty() && std::ranges::find(names, name) == names.end()) {
    section.report("stage", fmt::format("unknown stage \"{}\"{}", name, suggestion(name, names)));
  }
  return name;
}

}  // namespace

std::vector<Measurement> read_measurements(const Section& deck, const std::vector<ShiftedMaterial>& materials,
                                           const std::vector<Stage>& stages, const Tests& tests) {
  std::vector<Measurement> measurements;
  if (!deck.has("measurements")) return measurements;
  for (const auto& section : deck.sections("measurements")) {
    Measurement measurement;
    measurement.label = section.text("name");
    if (std::ranges::find(measurements, measurement.label, &Measurement::label) != measurements.end()) {
      section.report("name", fmt::format("another measurement is called \"{}\"", measurement.label));
    }
    measurement.stage = read_stage(section, stages);
    const auto key = section.exactly_one({"shear", "young", "bulk"});
    if (!key.empty()) {
      measurement.kind = *value_named<ModulusKind>(key);
      read_measured_modulus(section.section(key), materials, measurement);
    }
    if (section.has("times")) measurement.times = read_time_window(section, "times");
    const bool tests_shear = std::ranges::find(tests.loads, shear_of_material(tests)) != tests.loads.end();
    if (key == "shear" && !tests_shear) section.report(key, "tests.loads has no \"shear\" that could be compared");
    measurements.push_back(std::move(measurement));
  }
  return measurements;
}

}  // namespace breccia
