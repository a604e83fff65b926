#include "results/study_entries.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/chrono.h>
#include <fmt/ranges.h>

#include "breccia/homogenisation/stage_discretisation.hpp"

#include "homogenisation/crystal_words.hpp"
#include "homogenisation/debonding_words.hpp"
#include "homogenisation/narrow_gaps.hpp"
#include "homogenisation/quality.hpp"
#include "homogenisation/whole_filler.hpp"
#include "microstructure/image/image_sides.hpp"
#include "study/filler_shapes.hpp"
#include "study/identity.hpp"
#include "study/picture_words.hpp"
#include "study/test_rules.hpp"

namespace breccia {
namespace {

/// A number for a file; nothing where it is infinite, like the gap of a box without two particles.
std::optional<double> if_finite(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

MaterialEntry entry_of(const Material& material) {
  return {.name = material.name, .density = material.density, .bulk = material.bulk, .shear = material.shear};
}

/// The moduli of the first phase, the matrix, then those of the other phases by name.
SnapshotEntry entry_of(const Snapshot& snapshot, const std::vector<std::string>& phases) {
  const auto& [moduli, error] = snapshot;
  SnapshotEntry entry{.shear = moduli.front().shear, .bulk = moduli.front().bulk};
  if (error > 0.0) entry.error_before = error;
  for (std::size_t k = 1; k < phases.size(); ++k) {
    if (!entry.phases) entry.phases.emplace();
    entry.phases->push_back({phases[k], moduli[k]});
  }
  return entry;
}

DomainEntry entry_of(const TimeDomain& domain, std::size_t points) {
  return {.density_factor = domain.mass_scaling,
          .time_step = domain.time_step,
          .ramp = domain.ramp,
          .valid = domain.window,
          .steps = domain.steps,
          .terms = domain.terms,
          .reduction_error = domain.reduction_error,
          .seconds = domain.seconds,
          .point_steps_per_second = domain.point_steps_per_second(points)};
}

/// The settings and the accuracy of a test: a visitor of its record.
struct RecordEntry {
  const Tests& options;
  Mixing mixing;  ///< the one that the stage has
  int dimensions;
  const TestResult& test;
  std::size_t points;  ///< number of material points of the grid
  TestEntry& entry;

  void operator()(std::monostate /*unknown*/) const {}
  void operator()(const ExtrapolationRecord& record) const { entry.record = record; }
  void operator()(const MeanRecord& record) const {
    entry.record = MeanEntry{record.loads, if_finite(test.error_estimate)};
  }

  void operator()(const QuasistaticRecord& record) const {
    QuasistaticEntry found{.solver = record.reduced ? Solver::reduced : Solver::stepping,
                           .error_estimate = test.error_estimate,
                           .linear = record.effort,
                           .seconds = test.seconds,
                           .fit_error = record.fit_error};
    if (test.id.grid.is_films()) {
      if (dimensions == 2) found.face_share = options.films.face_share;
      if (dimensions == 3) found.divisions = options.films.divisions;
      found.layers = options.films.layers;
    } else {
      found.volumetric = options.volumetric;
      found.mixing = mixing;
    }
    if (record.reduced) {
      found.tolerance = options.quasistatic.sampling.tolerance;
      found.range = options.quasistatic.range;
      found.snapshots.emplace();
      for (const auto& snapshot : record.reduced->snapshots) {
        found.snapshots->push_back(entry_of(snapshot, record.reduced->phases()));
      }
    } else {
      found.steps_per_decade = options.quasistatic.steps_per_decade;
    }
    entry.record = std::move(found);
  }

  void operator()(const DynamicRecord& record) const {
    DynamicEntry found{.formulation = options.dynamic.formulation,
                       .start = options.dynamic.start,
                       .volumetric = options.volumetric,
                       .mixing = mixing,
                       .courant = options.dynamic.courant,
                       .overlaps = record.overlaps,
                       .fit_error = record.fit_error};
    for (const auto& domain : record.domains) found.domains.push_back(entry_of(domain, points));
    entry.record = std::move(found);
  }
};

TestEntry entry_of(const TestResult& test, const Study& study, const Stage& stage, Mixing mixing,
                   const StageRecord& record) {
  const auto cells = test.id.grid.cells();
  TestEntry entry{.id = test.id, .fields = record.fields_of(test.id)};
  std::visit(RecordEntry{study.tests, mixing, stage.dimensions(), test, cells ? point_count(stage, *cells) : 0, entry},
             test.record);
  return entry;
}

/// All grids of a stage, or the model of films.
std::vector<TestGrid> grids_of(const Tests& tests, const Stage& stage) {
  if (model_of(tests, stage) == Model::films) return {TestGrid::films()};
  std::vector<TestGrid> grids;
  for (const int cells : stage.grids()) grids.emplace_back(cells);
  return grids;
}

std::optional<RatioEntry> entry_of(const ComparedSample* sample) {
  return sample == nullptr ? std::nullopt : std::optional(RatioEntry{sample->time, sample->ratio()});
}

std::optional<FrequencyRatioEntry> entry_of(const ComparedComplexSample* sample) {
  if (sample == nullptr) return std::nullopt;
  return FrequencyRatioEntry{sample->angular_frequency / (2.0 * std::numbers::pi), sample->ratio()};
}

BoundsEntry entry_of(const BoundsAtTime& bounds) {
  return {bounds.time, bounds.upper, bounds.lower, bounds.distance(), bounds.grid_half_band};
}

QualityEntry entry_of(const StageQuality& quality) {
  QualityEntry entry{.summary = summary_of(quality),
                     .fraction_asked = quality.fraction_asked,
                     .gap_cells = if_finite(quality.gap_cells),
                     .coating_cells = quality.coating_cells,
                     .grids = quality.grids.size(),
                     .grid_error = quality.grid_share};
  entry.expected_grid_error = quality.rules.one_grid;
  if (quality.one_grid) entry.grid_rule = words_on_rule(*quality.one_grid);
  entry.sample = quality.rules.sample;
  entry.effective_particles = quality.rules.effective_particles;
  entry.error_asked = quality.error_asked;
  entry.error = quality.error;
  entry.sample_error = quality.sample_error;
  entry.filler_on_sides = quality.filler_on_sides;
  if (const auto grids = grids_that_measure(quality)) entry.measuring_grids.emplace(grids->begin(), grids->end());
  entry.anisotropy = quality.anisotropy;
  entry.space = quality.space;
  if (quality.is_random) entry.seeds = 1;
  for (const int grid : std::isfinite(quality.gap_cells) ? quality.grids : std::vector<int>()) {
    if (!entry.gap_cells_by_grid) entry.gap_cells_by_grid.emplace();
    entry.gap_cells_by_grid->push_back(quality.gap_cells_on(grid));
  }
  for (const auto& load : quality.loads) {
    if (load.times.empty()) continue;
    entry.bounds.push_back({load.load, load.method, entry_of(load.times.front()), entry_of(load.times.back())});
  }
  return entry;
}

/// The materials of all fillers, each once: "ap, aluminium"; nothing without a filler.
std::optional<std::string> name_of_fillers(const Stage& stage) {
  std::vector<std::string> names;
  for (const auto& filler : stage.fillers) {
    if (std::ranges::find(names, filler.material.name) == names.end()) names.push_back(filler.material.name);
  }
  return names.empty() ? std::nullopt : std::optional(fmt::format("{}", fmt::join(names, ", ")));
}

std::vector<FillerEntry> entries_of_fillers(const Stage& stage, const std::vector<FillerStatistics>& packed) {
  std::vector<FillerEntry> entries;
  for (std::size_t number = 0; number < std::min(stage.fillers.size(), packed.size()); ++number) {
    const auto& filler = stage.fillers[number];
    const auto& statistics = packed[number];
    auto& entry = entries.emplace_back(FillerEntry{.material = filler.material.name,
                                                   .fraction = statistics.fraction,
                                                   .fraction_asked = filler.fraction,
                                                   .smallest_diameter = statistics.smallest_diameter,
                                                   .largest_diameter = statistics.largest_diameter,
                                                   .size_deviation = statistics.size_deviation});
    if (!stage.has_image()) entry.particles = statistics.particles;
    if (stage.is_random()) entry.gap = filler.gap;
    if (const auto& coating = filler.coating) {
      entry.coating = {coating->material.name, coating->thickness, coating->thickness / stage.cell_size(),
                       statistics.coating_fraction};
    }
    if (filler.shape) entry.shape = in_words(*filler.shape, stage.dimensions());
  }
  return entries;
}

GreySideEntry entry_of(const Stage& stage, const GreySide& side) {
  return {material_of_label(stage, side.label), side.darkest, side.brightest, side.mean, side.share};
}

ThresholdEntry entry_of(const Stage& stage, const GreySegmentation& made) {
  return {.value = made.threshold,
          .method = made.is_otsu ? "otsu" : "given",
          .median_side = made.median_side,
          .separability = made.separability,
          .dark = entry_of(stage, made.dark),
          .bright = entry_of(stage, made.bright),
          .words = fmt::format("{}", fmt::join(words_on_threshold(stage), "; "))};
}

BoxSides sides_of(Walls walls) {
  return walls == Walls::periodic ? BoxSides::periodic : BoxSides::hard;
}

/// Adds the entries of study.json on the content of a box, in addition to the statistics of every content.
struct AddContent {
  const Stage& stage;
  const StageMicrostructure& packed;
  MicrostructureEntry& entry;

  template <int dim>
  void operator()(const Microstructure<dim>& balls) const {
    entry.sides = sides_of(balls.walls);
    add_diameters(balls.particles, [](const Ball<dim>& ball) { return ball.diameter; });
  }
  void operator()(const ParticleBox& box) const {
    entry.sides = sides_of(box.walls);
    add_diameters(box.particles, [](const Particle& particle) { return equivalent_diameter(particle.shape); });
  }
  void operator()(const EllipsoidBox& box) const {
    entry.sides = sides_of(box.walls);
    add_diameters(box.particles, [](const Ellipsoid& ellipsoid) { return equivalent_diameter(ellipsoid); });
  }
  template <int dim>
  void operator()(const Grains<dim>& grains) const {
    const auto& filler = packed.fillers.front();
    entry.sides = sides_of(grains.sites.walls);
    if (stage.has_cut_grains()) entry.sides = BoxSides::cut;
    entry.film = grains.statistics.film;
    entry.film_cells = grains.statistics.film / stage.cell_size();
    if (stage.bonds) {
      entry.debonding = {.kind = std::string(name_of(stage.bonds->kind)),
                         .films = grains.statistics.debonded_films,
                         .share = grains.statistics.debonded,
                         .words = words_on_debonding(stage, grains.statistics)};
      if (stage.bonds->kind == Debonding::spring) {
        entry.debonding->normal_stiffness = stage.bonds->springs.normal;
        entry.debonding->tangential_stiffness = stage.bonds->springs.tangential;
      }
    }
    entry.smallest_diameter = filler.smallest_diameter;
    entry.largest_diameter = filler.largest_diameter;
    entry.seed = stage.seed();
  }
  template <int dim>
  void operator()(const SharedImage<dim>& image) const {
    entry.particles.reset();  // pixels do not distinguish particles
    entry.pixels.emplace(image->pixels.begin(), image->pixels.end());
    entry.pixel_side = image->pixel_side;
    entry.cut_share = cut_share(*image);
    entry.seam = seam_of(*image).across;
    const auto* const pixels = stage.packed_by<ImagePacking<dim>>();
    if (pixels != nullptr && pixels->segmentation) entry.threshold = entry_of(stage, *pixels->segmentation);
  }

 private:
  template <class Particles, class Diameter>
  void add_diameters(const Particles& particles, const Diameter& diameter) const {
    if (particles.empty()) return;
    const auto [smallest, largest] = std::ranges::minmax(particles, {}, diameter);
    entry.smallest_diameter = diameter(smallest);
    entry.largest_diameter = diameter(largest);
  }
};

MicrostructureEntry entry_of(const Stage& stage, const StageMicrostructure& packing) {
  MicrostructureEntry entry{.particles = packing.particles(),
                            .fraction = packing.fraction,
                            .gap = if_finite(packing.gap),
                            .gap_cells = if_finite(packing.gap / stage.cell_size()),
                            .wall_gap = if_finite(packing.wall_gap),
                            .seconds = packing.seconds};
  (stage.dimensions() == 3 ? entry.interface_per_volume : entry.interface_per_area) = packing.interface_per_area;
  visit_nested(AddContent{stage, packing, entry}, packing.box);
  if (auto crystals = words_on_crystals(stage); !crystals.empty()) entry.crystals = std::move(crystals);
  entry.size_deviation = packing.size_deviation();
  if (!stage.fillers.empty() && stage.is_random()) {
    entry.seed = stage.seed().value();
    entry.events = packing.events;
  }
  return entry;
}

StageEntry entry_of(const Stage& stage, const StageResult& result, const Study& study, const StageRecord& record) {
  StageEntry entry{.name = stage.name,
                   .matrix = name_of(stage.matrix),
                   .filler = name_of_fillers(stage),
                   .fillers = entries_of_fillers(stage, result.microstructure.fillers),
                   .dimensions = stage.dimensions(),
                   .side = stage.side,
                   .grids = grids_of(study.tests, stage),
                   .points = result.points,
                   .point_fraction = result.point_fraction,
                   .microstructure = entry_of(stage, result.microstructure),
                   .quality = entry_of(quality_of(study, stage, result)),
                   .warnings = result.warnings};
  const auto mixing = mixing_of(study, stage, result.microstructure);
  for (const auto& test : result.tests) entry.tests.push_back(entry_of(test, study, stage, mixing, record));
  for (const auto& [boundary, method, fit] : result.materials) {
    entry.materials.push_back({boundary, method, fit.fitted, fit.shear_error, fit.bulk_error, entry_of(fit.material)});
  }
  for (const auto& comparison : result.comparisons) {
    entry.comparisons.push_back({comparison.measurement, comparison.kind, comparison.test.boundary,
                                 comparison.test.method, entry_of(comparison.best()), entry_of(comparison.worst()),
                                 entry_of(comparison.best_in_frequency()), entry_of(comparison.worst_in_frequency())});
  }
  if (!record.answered_from.empty()) entry.answered_from = record.answered_from;
  return entry;
}

/// The entry on the filler of the whole composite; nothing without a filler.
std::optional<WholeFillerEntry> entry_of(const WholeFiller& filler) {
  if (!(filler.fraction > 0.0) && !(filler.porosity > 0.0)) return std::nullopt;
  WholeFillerEntry entry{filler.fraction, filler.mass_fraction, filler.materials};
  if (!filler.coatings.empty()) entry.coatings = filler.coatings;
  if (filler.porosity > 0.0) entry.porosity = filler.porosity;
  return entry;
}

/// The present time in UTC as ISO 8601: "2026-01-31T12:00:00Z".
std::string date_of_now() {
  const auto now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now));
}

}  // namespace

StudyDocument document_of(const Study& study, const StudyResult& result, const StageRecords& records) {
  const auto provenance = provenance_of(study);
  StudyDocument document{.program = "breccia",
                         .version = BRECCIA_VERSION,
                         .title = study.title,
                         .deck = provenance.deck.string(),
                         .overrides = provenance.overrides,
                         .hash = provenance.hash,
                         .deck_content_hash = provenance.deck_content_hash,
                         .file_hashes = provenance.file_hashes,
                         .is_complete = result.seconds.has_value(),
                         .seconds = result.seconds,
                         .deck_text = provenance.deck_text,
                         .times = {study.tests.first_time, study.tests.last_time}};
  if (study.tests.by_frequency) {
    constexpr double per_cycle = 2.0 * std::numbers::pi;
    document.frequencies = {1.0 / (per_cycle * study.tests.last_time), 1.0 / (per_cycle * study.tests.first_time)};
  }
  if (result.seconds) document.date = date_of_now();
  for (const auto& [material, shift, constants, expansion] : study.materials) {
    auto& entry = document.materials.emplace_back(entry_of(material));
    entry.shift = shift;
    entry.thermal_expansion = expansion;
    if (constants) entry.constants.emplace(constants->begin(), constants->end());
  }
  for (const auto& stage : study.stages) document.stage_names.push_back(stage.name);
  std::vector<std::vector<FillerStatistics>> fillers;
  for (std::size_t i = 0; i < result.stages.size(); ++i) {
    const auto& stage = study.stages[i];
    const auto record = records.find(stage.name);
    auto& entry = document.stages.emplace_back(
        entry_of(stage, result.stages[i], study, record == records.end() ? StageRecord() : record->second));
    fillers.push_back(result.stages[i].microstructure.fillers);
    entry.whole_filler = entry_of(filler_of_the_whole(study, stage, fillers));
  }
  return document;
}

}  // namespace breccia
