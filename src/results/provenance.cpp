#include "breccia/results/provenance.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/chrono.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "breccia/homogenisation/quality.hpp"
#include "breccia/homogenisation/stage_discretisation.hpp"
#include "breccia/homogenisation/whole_filler.hpp"
#include "breccia/io/text_file.hpp"
#include "breccia/study/filler_shapes.hpp"
#include "breccia/study/identity.hpp"
#include "breccia/study/test_rules.hpp"

namespace breccia {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const PronySeries& series) {
  Json terms = Json::array();
  for (const auto& [relaxation_time, modulus] : series.terms()) {
    terms.push_back({{"relaxation_time_s", relaxation_time}, {"modulus_Pa", modulus}});
  }
  return {{"equilibrium_Pa", series.equilibrium()}, {"terms", std::move(terms)}};
}

Json json_of(const Material& material) {
  return {{"name", material.name},
          {"density_kg_per_m3", material.density},
          {"bulk", json_of(material.bulk)},
          {"shear", json_of(material.shear)}};
}

Json json_of(const WilliamsLandelFerry& law) {
  return {{"c1", law.c1}, {"c2_K", law.c2}, {"reference_K", law.reference_temperature}};
}

Json json_of(const ShiftTable& table) {
  return {{"temperatures_K", table.temperatures()},
          {"log10_shift_factors", table.log10_factors()},
          {"reference_K", table.reference_temperature()}};
}

Json json_of(const TemperatureShift& shift) {
  auto json = std::visit([](const auto& law) { return json_of(law); }, shift.law);
  json["temperature_K"] = shift.temperature;
  return json;
}

Json json_of(const TimeWindow& window) {
  return {window.begin, window.end};
}

Json json_of(const ComparedSample& sample) {
  return {{"time_s", sample.time}, {"ratio", sample.ratio()}};
}

Json json_of(const std::optional<double>& number) {
  return number ? Json(*number) : Json();
}

/// A number for JSON, which has no infinity: the gap without two particles is null.
Json finite_or_null(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}

Json json_of(const TimeDomain& domain, std::size_t points) {
  return {{"density_factor", domain.mass_scaling},
          {"time_step_s", domain.time_step},
          {"ramp_s", domain.ramp},
          {"valid_s", json_of(domain.window)},
          {"steps", domain.steps},
          {"active_terms", domain.terms},
          {"reduction_error", domain.reduction_error},
          {"wall_time_s", domain.seconds},
          {"points_x_steps_per_s", domain.point_steps_per_second(points)}};
}

Json json_of(const LinearEffort& effort) {
  return {{"method", effort.is_direct ? "direct" : "iterative"},
          {"unknowns", effort.unknowns},
          {"factorisations", effort.factorisations},
          {"solves", effort.solves},
          {"iterations", effort.iterations},
          {"most_iterations", effort.most_iterations},
          {"largest_residual", effort.largest_residual}};
}

/// The moduli of the first phase, the matrix, then those of the others by name.
Json json_of(const Snapshot& snapshot, const std::vector<std::string>& phases) {
  const auto& [moduli, error] = snapshot;
  Json json = {{"shear_Pa", moduli.front().shear},
               {"bulk_Pa", moduli.front().bulk},
               {"error_before", error > 0.0 ? Json(error) : Json()}};
  for (std::size_t k = 1; k < phases.size(); ++k) {
    json["phases"][phases[k]] = {{"shear_Pa", moduli[k].shear}, {"bulk_Pa", moduli[k].bulk}};
  }
  return json;
}

Json json_of(const WholeFiller& filler) {
  const auto listed = [](const std::vector<FillerShare>& shares) {
    Json materials = Json::array();
    for (const auto& [material, fraction, mass_fraction] : shares) {
      materials.push_back({{"material", material}, {"fraction", fraction}, {"mass_fraction", mass_fraction}});
    }
    return materials;
  };
  Json json = {
      {"fraction", filler.fraction}, {"mass_fraction", filler.mass_fraction}, {"materials", listed(filler.materials)}};
  if (!filler.coatings.empty()) json["coatings"] = listed(filler.coatings);
  return json;
}

/// Writes the settings and the accuracy of a test.
struct DescribeRecord {
  const Tests& options;
  const TestResult& test;
  std::size_t points;  ///< material points of the grid

  Json operator()(const QuasistaticRecord& record) const {
    Json json = {{"solver", name_of(record.reduced ? Solver::reduced : Solver::stepping)}};
    if (test.id.grid.is_films()) {
      json["face_share"] = options.films.face_share;
      if (options.films.layers) json["layers"] = *options.films.layers;
    } else {
      json["volumetric"] = name_of(options.quasistatic.volumetric);
      json["mixing"] = name_of(options.mixing);
    }
    json["error_estimate"] = test.error_estimate;
    json["linear"] = json_of(record.effort);
    json["wall_time_s"] = json_of(test.seconds);
    if (record.fit_error) json["fit_error"] = *record.fit_error;
    if (!record.reduced) {
      json["steps_per_decade"] = options.quasistatic.steps_per_decade;
      return json;
    }
    json["tolerance"] = options.quasistatic.sampling.tolerance;
    json["range"] = name_of(options.quasistatic.range);
    json["snapshots"] = Json::array();
    for (const auto& snapshot : record.reduced->snapshots) {
      json["snapshots"].push_back(json_of(snapshot, record.reduced->phases()));
    }
    return json;
  }

  Json operator()(const DynamicRecord& record) const {
    Json domains = Json::array(), overlaps = Json::array();
    for (const auto& domain : record.domains) domains.push_back(json_of(domain, points));
    for (const auto& [window, mismatch] : record.overlaps) {
      overlaps.push_back({{"window_s", json_of(window)}, {"mismatch", mismatch}});
    }
    Json json = {{"formulation", name_of(options.dynamic.formulation)},
                 {"start", name_of(options.dynamic.start)},
                 {"volumetric", name_of(options.dynamic.volumetric)},
                 {"mixing", name_of(options.mixing)},
                 {"courant", options.dynamic.courant},
                 {"time_domains", std::move(domains)},
                 {"overlaps", std::move(overlaps)}};
    if (record.fit_error) json["fit_error"] = *record.fit_error;
    return json;
  }

  Json operator()(std::monostate /*record*/) const { return Json::object(); }
  Json operator()(const ExtrapolationRecord& record) const { return {{"from_cells", record.cells}}; }
};

Json json_of(const TestResult& test, const Study& study, const Stage& stage, const StageRecord& record) {
  const auto cells = test.id.grid.cells();
  const auto points = cells ? point_count(stage, *cells) : 0;
  Json json = {{"load", name_of(test.id.load)},
               {"boundary", name_of(test.id.boundary)},
               {"method", name_of(test.id.method)},
               {"cells", cells ? Json(*cells) : Json(name_of(test.id.grid))}};
  json.update(std::visit(DescribeRecord{study.tests, test, points}, test.record));
  for (const auto& [time, file, stress, strain, work] : record.fields_of(test.id)) {
    Json field = {{"time_s", time}, {"file", file}, {"stress_picture", stress}, {"strain_picture", strain}};
    if (!work.empty()) field["work_picture"] = work;
    json["fields"].push_back(std::move(field));
  }
  return json;
}

/// Cells per side of all grids, or "films".
Json names_of_grids(const Tests& tests, const Stage& stage) {
  if (model_of(tests, stage) == Model::films) return Json::array({name_of(TestGrid::films())});
  return stage.grids();
}

Json json_of(const BoundsAtTime& bounds) {
  return {{"time_s", bounds.time},
          {"upper_Pa", json_of(bounds.upper)},
          {"lower_Pa", json_of(bounds.lower)},
          {"relative_distance", json_of(bounds.distance())},
          {"grid_half_band_Pa", json_of(bounds.grid_half_band)}};
}

Json json_of(const StageQuality& quality) {
  Json bounds = Json::array();
  for (const auto& load : quality.loads) {
    if (load.times.empty()) continue;
    bounds.push_back({{"load", name_of(load.load)},
                      {"method", name_of(load.method)},
                      {"first", json_of(load.times.front())},
                      {"last", json_of(load.times.back())}});
  }
  Json gaps;
  for (const int grid : std::isfinite(quality.gap_cells) ? quality.grids : std::vector<int>()) {
    gaps.push_back(quality.gap_cells_on(grid));
  }
  return {{"summary", summary_of(quality)},
          {"fraction_asked", json_of(quality.fraction_asked)},
          {"narrowest_gap_cells", finite_or_null(quality.gap_cells)},
          {"narrowest_gap_cells_by_grid", std::move(gaps)},
          {"thinnest_coating_cells", json_of(quality.coating_cells)},
          {"grids", quality.grids.size()},
          {"grid_error", json_of(quality.grid_share)},
          {"seeds", quality.is_random ? Json(1) : Json()},
          {"bounds", std::move(bounds)}};
}

/// The materials of all fillers, each once: "ap, aluminium"; null without a filler.
Json name_of_fillers(const Stage& stage) {
  std::vector<std::string> names;
  for (const auto& filler : stage.fillers) {
    if (std::ranges::find(names, filler.material.name) == names.end()) names.push_back(filler.material.name);
  }
  return names.empty() ? Json() : Json(fmt::format("{}", fmt::join(names, ", ")));
}

Json json_of(const Stage& stage, const std::vector<FillerStatistics>& packed) {
  Json fillers = Json::array();
  for (std::size_t number = 0; number < std::min(stage.fillers.size(), packed.size()); ++number) {
    const auto& [material, fraction, smallest, largest, sizes, gap, gap_source, coating, shape] = stage.fillers[number];
    const auto& statistics = packed[number];
    Json filler = {{"material", material.name},
                   {"particles", stage.has_image() ? Json() : Json(statistics.particles)},
                   {"fraction", statistics.fraction},
                   {"fraction_asked", json_of(fraction)},
                   {"smallest_diameter_m", json_of(statistics.smallest_diameter)},
                   {"largest_diameter_m", json_of(statistics.largest_diameter)},
                   {"size_distribution_deviation", json_of(statistics.size_deviation)},
                   {"gap_m", stage.is_random() ? Json(gap) : Json()},
                   {"coating", Json()}};
    if (coating) {
      filler["coating"] = {{"material", coating->material.name},
                           {"thickness_m", coating->thickness},
                           {"thickness_cells", coating->thickness / stage.cell_size()},
                           {"fraction", statistics.coating_fraction}};
    }
    if (shape) filler["shape"] = in_words(*shape, stage.dimensions());
    fillers.push_back(std::move(filler));
  }
  return fillers;
}

/// Adds what study.json has of the content of a box, beside the statistics that every content has.
struct AddContent {
  const Stage& stage;
  const StageMicrostructure& packed;
  Json& json;

  template <int dim>
  void operator()(const Microstructure<dim>& balls) const {
    add_diameters(balls.particles, [](const Ball<dim>& ball) { return ball.diameter; });
  }
  void operator()(const ParticleBox& box) const {
    add_diameters(box.particles, [](const Particle& particle) { return equivalent_diameter(particle.shape); });
  }
  void operator()(const EllipsoidBox& box) const {
    add_diameters(box.particles, [](const Ellipsoid& ellipsoid) { return equivalent_diameter(ellipsoid); });
  }
  template <int dim>
  void operator()(const Grains<dim>& grains) const {
    const auto& filler = packed.fillers.front();
    json["film_m"] = grains.statistics.film;
    json["film_cells"] = grains.statistics.film / stage.cell_size();
    json["smallest_diameter_m"] = json_of(filler.smallest_diameter);
    json["largest_diameter_m"] = json_of(filler.largest_diameter);
    if (const auto seed = stage.seed()) json["seed"] = *seed;
  }
  template <int dim>
  void operator()(const SharedImage<dim>& image) const {
    json["particles"] = Json();  // pixels do not tell one particle from another
    json["pixels"] = image->pixels;
    json["pixel_m"] = image->pixel_side;
  }

 private:
  template <class Particles, class Diameter>
  void add_diameters(const Particles& particles, const Diameter& diameter) const {
    if (particles.empty()) return;
    const auto [smallest, largest] = std::ranges::minmax(particles, {}, diameter);
    json["smallest_diameter_m"] = diameter(smallest);
    json["largest_diameter_m"] = diameter(largest);
  }
};

Json json_of(const Stage& stage, const StageResult& result, const Study& study, const StageRecord& record) {
  const auto& packing = result.microstructure;
  Json microstructure = {{"particles", packing.particles()},
                         {"fraction", packing.fraction},
                         {stage.dimensions() == 3 ? "interface_per_volume_1_per_m" : "interface_per_area_1_per_m",
                          packing.interface_per_area},
                         {"smallest_gap_m", finite_or_null(packing.gap)},
                         {"smallest_gap_cells", finite_or_null(packing.gap / stage.cell_size())},
                         {"smallest_wall_gap_m", finite_or_null(packing.wall_gap)},
                         {"wall_time_s", packing.seconds}};
  visit_nested(AddContent{stage, packing, microstructure}, packing.box);
  if (const auto deviation = packing.size_deviation()) microstructure["size_distribution_deviation"] = *deviation;
  if (!stage.fillers.empty() && stage.is_random()) {
    microstructure["seed"] = stage.seed().value();
    microstructure["events"] = packing.events;
  }
  Json materials = Json::array();
  for (const auto& [boundary, method, fit] : result.materials) {
    materials.push_back({{"boundary", name_of(boundary)},
                         {"method", name_of(method)},
                         {"fitted_over_s", json_of(fit.fitted)},
                         {"shear_fit_error", fit.shear_error},
                         {"bulk_fit_error", fit.bulk_error},
                         {"material", json_of(fit.material)}});
  }
  Json comparisons = Json::array();
  for (const auto& comparison : result.comparisons) {
    comparisons.push_back({{"measurement", comparison.measurement},
                           {"boundary", name_of(comparison.test.boundary)},
                           {"method", name_of(comparison.test.method)},
                           {"best", json_of(comparison.best())},
                           {"worst", json_of(comparison.worst())}});
  }
  Json tests = Json::array();
  for (const auto& test : result.tests) tests.push_back(json_of(test, study, stage, record));
  Json json = {{"name", stage.name},
               {"matrix", name_of(stage.matrix)},
               {"filler", name_of_fillers(stage)},
               {"fillers", json_of(stage, packing.fillers)},
               {"dimensions", stage.dimensions()},
               {"box_m", stage.side},
               {"cells", names_of_grids(study.tests, stage)},
               {"points", result.points},
               {"filler_point_fraction", result.point_fraction},
               {"microstructure", std::move(microstructure)},
               {"tests", std::move(tests)},
               {"materials", std::move(materials)},
               {"comparisons", std::move(comparisons)},
               {"quality", json_of(quality_of(stage, result))},
               {"warnings", result.warnings}};
  if (!record.answered_from.empty()) json["answered_from"] = record.answered_from;
  return json;
}

Json json_of(const std::vector<FileHash>& files) {
  Json hashes = Json::object();
  for (const auto& [name, hash] : files) hashes[name] = hash;
  return hashes;
}

/// The present time in UTC as ISO 8601: "2026-01-31T12:00:00Z".
std::string date_of_now() {
  const auto now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now));
}

}  // namespace

void write_provenance(const std::filesystem::path& directory, const Study& study, const StudyResult& result,
                      const StageRecords& records) {
  Json materials = Json::array(), stages = Json::array(), stage_names = Json::array();
  for (const auto& stage : study.stages) stage_names.push_back(stage.name);
  for (const auto& material : study.materials) {
    materials.push_back(json_of(material));
    const auto shift = study.temperature_shifts.find(material.name);
    if (shift != study.temperature_shifts.end()) materials.back()["temperature_shift"] = json_of(shift->second);
  }
  std::vector<std::vector<FillerStatistics>> fillers;
  for (std::size_t i = 0; i < result.stages.size(); ++i) {
    const auto record = records.find(study.stages[i].name);
    stages.push_back(
        json_of(study.stages[i], result.stages[i], study, record == records.end() ? StageRecord() : record->second));
    fillers.push_back(result.stages[i].microstructure.fillers);
    const auto whole = filler_of_the_whole(study, study.stages[i], fillers);
    if (whole.fraction > 0.0) stages.back()["filler_of_the_whole"] = json_of(whole);
  }
  const auto provenance = provenance_of(study);
  const Json json = {{"program", "breccia"},
                     {"version", BRECCIA_VERSION},
                     {"title", study.title},
                     {"deck", provenance.deck.string()},
                     {"overrides", provenance.overrides},
                     {"hash", provenance.hash},
                     {"deck_content_hash", provenance.deck_content_hash},
                     {"file_hashes", json_of(provenance.file_hashes)},
                     {"complete", result.seconds.has_value()},
                     {"date", result.seconds ? Json(date_of_now()) : Json()},
                     {"wall_time_s", result.seconds ? Json(*result.seconds) : Json()},
                     {"deck_text", provenance.deck_text},
                     {"times_s", {study.tests.first_time, study.tests.last_time}},
                     {"materials", std::move(materials)},
                     {"stage_names", std::move(stage_names)},
                     {"stages", std::move(stages)}};
  write_text(directory / "study.json", json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace breccia
