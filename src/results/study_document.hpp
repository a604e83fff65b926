#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "breccia/error.hpp"
#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/study.hpp"
#include "breccia/viscoelasticity/prony_series.hpp"

#include "dynamics/dynamic_solver.hpp"
#include "homogenisation/anisotropy.hpp"
#include "homogenisation/factor_of_space.hpp"
#include "homogenisation/whole_filler.hpp"
#include "results/comparison_entries.hpp"
#include "results/json_fields.hpp"
#include "results/material_entries.hpp"
#include "results/microstructure_entries.hpp"
#include "results/stage_record.hpp"

namespace breccia {

// The content of study.json, as docs/results.md describes it: structs with the values of the file, each followed by its
// description, from which it is written and read. Numbers that a file may have as null are optional.

template <>
struct JsonForm<TimeWindow> {
  static nlohmann::ordered_json write(const TimeWindow& window) { return {window.begin, window.end}; }
  static TimeWindow read(const nlohmann::ordered_json& json) {
    return {json.at(0).get<double>(), json.at(1).get<double>()};
  }
};

template <>
struct JsonForm<TestGrid> {
  static nlohmann::ordered_json write(const TestGrid& grid);
  static TestGrid read(const nlohmann::ordered_json& json);
};

template <>
inline constexpr auto fields<LinearEffort> = std::tuple(field("unknowns", &LinearEffort::unknowns),
                                                        field("factorisations", &LinearEffort::factorisations),
                                                        field("solves", &LinearEffort::solves),
                                                        field("iterations", &LinearEffort::iterations),
                                                        field("most_iterations", &LinearEffort::most_iterations),
                                                        field("largest_residual", &LinearEffort::largest_residual));
/// The object in the file also has the method of the solver.
template <>
struct JsonForm<LinearEffort> {
  static nlohmann::ordered_json write(const LinearEffort& effort);
  static LinearEffort read(const nlohmann::ordered_json& json);
};

template <>
inline constexpr auto fields<Moduli> = std::tuple(field("shear_Pa", &Moduli::shear), field("bulk_Pa", &Moduli::bulk));

/// Moduli of a phase, by its name.
struct PhaseModuli {
  std::string phase;
  Moduli moduli = {};
};
template <>
struct JsonForm<std::vector<PhaseModuli>> {
  static nlohmann::ordered_json write(const std::vector<PhaseModuli>& phases);
  static std::vector<PhaseModuli> read(const nlohmann::ordered_json& json);
};

/// Moduli of the matrix [Pa] and of the other phases.
struct SnapshotEntry {
  double shear = 0.0, bulk = 0.0;
  std::optional<double> error_before = {};
  std::optional<std::vector<PhaseModuli>> phases = {};
};
template <>
inline constexpr auto fields<SnapshotEntry> = std::tuple(field("shear_Pa", &SnapshotEntry::shear),
                                                         field("bulk_Pa", &SnapshotEntry::bulk),
                                                         field("error_before", &SnapshotEntry::error_before),
                                                         field_if_any("phases", &SnapshotEntry::phases));

struct QuasistaticEntry {
  Solver solver = Solver::reduced;
  std::optional<double> face_share = {};
  std::optional<int> layers = {};
  std::optional<int> divisions = {};
  std::optional<Volumetric> volumetric = {};
  std::optional<Mixing> mixing = {};
  std::optional<double> error_estimate = {};  ///< nothing where it is not known
  LinearEffort linear = {};
  std::optional<double> seconds = {};
  std::optional<double> fit_error = {};
  std::optional<int> steps_per_decade = {};
  std::optional<double> tolerance = {};
  std::optional<SampledRange> range = {};
  std::optional<std::vector<SnapshotEntry>> snapshots = {};
};
template <>
inline constexpr auto fields<QuasistaticEntry> = std::tuple(
    field("solver", &QuasistaticEntry::solver), field_if_any("face_share", &QuasistaticEntry::face_share),
    field_if_any("layers", &QuasistaticEntry::layers), field_if_any("divisions", &QuasistaticEntry::divisions),
    field_if_any("volumetric", &QuasistaticEntry::volumetric), field_if_any("mixing", &QuasistaticEntry::mixing),
    field("error_estimate", &QuasistaticEntry::error_estimate), field("linear", &QuasistaticEntry::linear),
    field("wall_time_s", &QuasistaticEntry::seconds), field_if_any("fit_error", &QuasistaticEntry::fit_error),
    field_if_any("steps_per_decade", &QuasistaticEntry::steps_per_decade),
    field_if_any("tolerance", &QuasistaticEntry::tolerance), field_if_any("range", &QuasistaticEntry::range),
    field_if_any("snapshots", &QuasistaticEntry::snapshots));

struct DomainEntry {
  double density_factor = 1.0;
  double time_step = 0.0, ramp = 0.0;  ///< [s]
  TimeWindow valid = {};               ///< [s]
  std::int64_t steps = 0;
  std::size_t terms = 0;
  double reduction_error = 0.0;
  double seconds = 0.0;
  double point_steps_per_second = 0.0;
};
template <>
inline constexpr auto fields<DomainEntry> = std::tuple(
    field("density_factor", &DomainEntry::density_factor), field("time_step_s", &DomainEntry::time_step),
    field("ramp_s", &DomainEntry::ramp), field("valid_s", &DomainEntry::valid), field("steps", &DomainEntry::steps),
    field("active_terms", &DomainEntry::terms), field("reduction_error", &DomainEntry::reduction_error),
    field("wall_time_s", &DomainEntry::seconds), field("points_x_steps_per_s", &DomainEntry::point_steps_per_second));

template <>
inline constexpr auto fields<Overlap> = std::tuple(field("window_s", &Overlap::window),
                                                   field("mismatch", &Overlap::mismatch));

struct DynamicEntry {
  Formulation formulation = {};
  Start start = {};
  Volumetric volumetric = {};
  Mixing mixing = {};
  double courant = 0.0;
  std::vector<DomainEntry> domains = {};
  std::vector<Overlap> overlaps = {};
  std::optional<double> fit_error = {};
};
template <>
inline constexpr auto fields<DynamicEntry> =
    std::tuple(field("formulation", &DynamicEntry::formulation), field("start", &DynamicEntry::start),
               field("volumetric", &DynamicEntry::volumetric), field("mixing", &DynamicEntry::mixing),
               field("courant", &DynamicEntry::courant), field("time_domains", &DynamicEntry::domains),
               field("overlaps", &DynamicEntry::overlaps), field_if_any("fit_error", &DynamicEntry::fit_error));

template <>
inline constexpr auto fields<ExtrapolationRecord> = std::tuple(field("from_cells", &ExtrapolationRecord::cells));

struct MeanEntry {
  std::vector<Load> loads = {};
  std::optional<double> error_estimate = {};
};
template <>
inline constexpr auto fields<MeanEntry> = std::tuple(field("mean_of", &MeanEntry::loads),
                                                     field_if_any("error_estimate", &MeanEntry::error_estimate));

template <>
inline constexpr auto fields<FieldRecord> = std::tuple(field("time_s", &FieldRecord::time),
                                                       field("file", &FieldRecord::file),
                                                       field("stress_picture", &FieldRecord::stress_picture),
                                                       field("strain_picture", &FieldRecord::strain_picture));
/// The object in the file also has the picture of the work, where there is one.
template <>
struct JsonForm<FieldRecord> {
  static nlohmann::ordered_json write(const FieldRecord& files);
  static FieldRecord read(const nlohmann::ordered_json& json);
};

template <>
inline TestId blank_value() {
  return {.grid = TestGrid::films()};
}
template <>
inline constexpr auto fields<TestId> = std::tuple(field("load", &TestId::load), field("boundary", &TestId::boundary),
                                                  field("method", &TestId::method), field("cells", &TestId::grid));

/// A test, whose object in the file has the fields of its identity, of its record where it is known, and the files of
/// its fields.
struct TestEntry {
  TestId id = blank_value<TestId>();
  std::variant<std::monostate, QuasistaticEntry, DynamicEntry, ExtrapolationRecord, MeanEntry> record = {};
  std::vector<FieldRecord> fields = {};
};
template <>
struct JsonForm<TestEntry> {
  static nlohmann::ordered_json write(const TestEntry& test);
  static TestEntry read(const nlohmann::ordered_json& json);
};

/// The stage as a material for later stages.
struct StageMaterialEntry {
  Boundary boundary = {};
  Method method = {};
  TimeWindow fitted = {};  ///< [s]
  double shear_error = 0.0, bulk_error = 0.0;
  MaterialEntry material = {};
};
template <>
inline constexpr auto fields<StageMaterialEntry> = std::tuple(
    field("boundary", &StageMaterialEntry::boundary), field("method", &StageMaterialEntry::method),
    field("fitted_over_s", &StageMaterialEntry::fitted), field("shear_fit_error", &StageMaterialEntry::shear_error),
    field("bulk_fit_error", &StageMaterialEntry::bulk_error), field("material", &StageMaterialEntry::material));

struct BoundsEntry {
  double time = 0.0;                             ///< [s]
  std::optional<double> upper = {}, lower = {};  ///< [Pa]
  std::optional<double> distance = {};
  std::optional<double> grid_half_band = {};  ///< [Pa]
};
template <>
inline constexpr auto fields<BoundsEntry> = std::tuple(field("time_s", &BoundsEntry::time),
                                                       field("upper_Pa", &BoundsEntry::upper),
                                                       field("lower_Pa", &BoundsEntry::lower),
                                                       field("relative_distance", &BoundsEntry::distance),
                                                       field("grid_half_band_Pa", &BoundsEntry::grid_half_band));

struct LoadBoundsEntry {
  TestLoad load = Load::shear;
  Method method = {};
  BoundsEntry first = {}, last = {};
};
template <>
inline constexpr auto fields<LoadBoundsEntry> = std::tuple(field("load", &LoadBoundsEntry::load),
                                                           field("method", &LoadBoundsEntry::method),
                                                           field("first", &LoadBoundsEntry::first),
                                                           field("last", &LoadBoundsEntry::last));

template <>
inline constexpr auto fields<AnisotropyAtTime> = std::tuple(field("time_s", &AnisotropyAtTime::time),
                                                            field("relative_distance", &AnisotropyAtTime::distance));
template <>
inline constexpr auto fields<Anisotropy> = std::tuple(field("first", &Anisotropy::first),
                                                      field("last", &Anisotropy::last));

template <>
inline constexpr auto fields<FactorOfSpace> = std::tuple(field("time_s", &FactorOfSpace::time),
                                                         field("ratio", &FactorOfSpace::ratio));

struct QualityEntry {
  std::string summary;
  std::optional<double> fraction_asked = {};
  std::optional<double> gap_cells = {};
  std::optional<std::vector<double>> gap_cells_by_grid = {};
  std::optional<double> coating_cells = {};
  std::size_t grids = 0;
  std::optional<double> grid_error = {};
  std::optional<double> expected_grid_error = {};
  std::optional<std::string> grid_rule = {};
  std::optional<std::vector<int>> measuring_grids = {};
  std::optional<int> seeds = {};
  std::optional<SampleKind> sample = {};
  std::optional<double> effective_particles = {};
  std::optional<double> error_asked = {}, error = {}, sample_error = {};
  std::optional<double> filler_on_sides = {};
  std::vector<LoadBoundsEntry> bounds = {};
  std::optional<Anisotropy> anisotropy = {};
  std::optional<FactorOfSpace> space = {};
};
template <>
inline constexpr auto fields<QualityEntry> = std::tuple(
    field("summary", &QualityEntry::summary), field("fraction_asked", &QualityEntry::fraction_asked),
    field("narrowest_gap_cells", &QualityEntry::gap_cells),
    field("narrowest_gap_cells_by_grid", &QualityEntry::gap_cells_by_grid),
    field("thinnest_coating_cells", &QualityEntry::coating_cells), field("grids", &QualityEntry::grids),
    field("grid_error", &QualityEntry::grid_error), field("expected_grid_error", &QualityEntry::expected_grid_error),
    field_if_any("grid_rule", &QualityEntry::grid_rule),
    field_if_any("measuring_grids", &QualityEntry::measuring_grids), field("seeds", &QualityEntry::seeds),
    field_if_any("sample", &QualityEntry::sample),
    field_if_any("effective_particles", &QualityEntry::effective_particles),
    field_if_any("error_asked", &QualityEntry::error_asked), field_if_any("largest_error", &QualityEntry::error),
    field_if_any("largest_sample_error", &QualityEntry::sample_error),
    field_if_any("filler_on_sides", &QualityEntry::filler_on_sides), field("bounds", &QualityEntry::bounds),
    field_if_any("anisotropy", &QualityEntry::anisotropy), field_if_any("spheres_over_discs", &QualityEntry::space));

/// The rules for the errors of a stage's moduli, as its quality has them.
[[nodiscard]] ErrorRules rules_in(const QualityEntry& quality);

template <>
inline constexpr auto fields<FillerShare> = std::tuple(field("material", &FillerShare::material),
                                                       field("fraction", &FillerShare::fraction),
                                                       field("mass_fraction", &FillerShare::mass_fraction));

struct WholeFillerEntry {
  double fraction = 0.0, mass_fraction = 0.0;
  std::vector<FillerShare> materials = {};
  std::optional<std::vector<FillerShare>> coatings = {};
  std::optional<double> porosity = {};
};
template <>
inline constexpr auto fields<WholeFillerEntry> = std::tuple(field("fraction", &WholeFillerEntry::fraction),
                                                            field("mass_fraction", &WholeFillerEntry::mass_fraction),
                                                            field("materials", &WholeFillerEntry::materials),
                                                            field_if_any("coatings", &WholeFillerEntry::coatings),
                                                            field_if_any("porosity", &WholeFillerEntry::porosity));

struct StageEntry {
  std::string name = {}, matrix = {};
  std::optional<std::string> filler = {};
  std::vector<FillerEntry> fillers = {};
  int dimensions = 2;
  double side = 0.0;  ///< [m]
  std::vector<TestGrid> grids = {};
  std::size_t points = 0;
  double point_fraction = 0.0;
  MicrostructureEntry microstructure = {};
  std::vector<TestEntry> tests = {};
  std::vector<StageMaterialEntry> materials = {};
  std::vector<ComparisonEntry> comparisons = {};
  QualityEntry quality = {};
  std::vector<std::string> warnings = {};
  std::optional<std::string> answered_from = {};
  std::optional<WholeFillerEntry> whole_filler = {};
};
template <>
inline constexpr auto fields<StageEntry> = std::tuple(
    field("name", &StageEntry::name), field("matrix", &StageEntry::matrix), field("filler", &StageEntry::filler),
    field("fillers", &StageEntry::fillers), field("dimensions", &StageEntry::dimensions),
    field("box_m", &StageEntry::side), field("cells", &StageEntry::grids), field("points", &StageEntry::points),
    field("filler_point_fraction", &StageEntry::point_fraction), field("microstructure", &StageEntry::microstructure),
    field("tests", &StageEntry::tests), field("materials", &StageEntry::materials),
    field("comparisons", &StageEntry::comparisons), field("quality", &StageEntry::quality),
    field("warnings", &StageEntry::warnings), field_if_any("answered_from", &StageEntry::answered_from),
    field_if_any("filler_of_the_whole", &StageEntry::whole_filler));

/// File names and their hashes are the keys and values of an object.
template <>
struct JsonForm<std::vector<FileHash>> {
  static nlohmann::ordered_json write(const std::vector<FileHash>& files);
  static std::vector<FileHash> read(const nlohmann::ordered_json& json);
};

/// The content of study.json.
struct StudyDocument {
  std::string program = {}, version = {}, title = {}, deck = {};
  std::vector<std::string> overrides = {};
  std::string hash = {}, deck_content_hash = {};
  std::vector<FileHash> file_hashes = {};
  bool is_complete = false;
  std::optional<std::string> date = {};  ///< UTC, ISO 8601
  std::optional<double> seconds = {};    ///< wall time of the complete study [s]
  std::string deck_text = {};
  TimeWindow times = {};  ///< [s]
  /// First and last frequency [Hz] of a study whose deck gives frequencies.
  std::optional<std::vector<double>> frequencies = {};
  std::vector<MaterialEntry> materials = {};
  std::vector<std::string> stage_names = {};  ///< names of all stages
  std::vector<StageEntry> stages = {};        ///< the stages that are packed
};
template <>
inline constexpr auto fields<StudyDocument> = std::tuple(
    field("program", &StudyDocument::program), field("version", &StudyDocument::version),
    field("title", &StudyDocument::title), field("deck", &StudyDocument::deck),
    field("overrides", &StudyDocument::overrides), field("hash", &StudyDocument::hash),
    field("deck_content_hash", &StudyDocument::deck_content_hash), field("file_hashes", &StudyDocument::file_hashes),
    field("complete", &StudyDocument::is_complete), field("date", &StudyDocument::date),
    field("wall_time_s", &StudyDocument::seconds), field("deck_text", &StudyDocument::deck_text),
    field("times_s", &StudyDocument::times), field_if_any("frequencies_Hz", &StudyDocument::frequencies),
    field("materials", &StudyDocument::materials), field("stage_names", &StudyDocument::stage_names),
    field("stages", &StudyDocument::stages));

/// Error: another version of Breccia has written a `study.json` that this version cannot read.
class OtherFormat : public FileError {
 public:
  OtherFormat(std::filesystem::path directory, const std::string& message)
      : FileError(message), directory_(std::move(directory)) {}
  /// That of the results.
  [[nodiscard]] const std::filesystem::path& directory() const noexcept { return directory_; }

 private:
  std::filesystem::path directory_;
};

/// Reads `study.json` in a directory. Throws OtherFormat, or FileError where it is not as `breccia run` of this version
/// writes it; names of stages and of files of fields are safe then.
StudyDocument read_study_document(const std::filesystem::path& directory);

/// Writes `study.json` in a directory. Throws FileError.
void write_study_document(const std::filesystem::path& directory, const StudyDocument& document);

}  // namespace breccia
