#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "breccia/checkpoint/checkpoint.hpp"
#include "breccia/study/microstructures.hpp"
#include "breccia/study/study.hpp"
#include "breccia/virtual_test/dynamic_test.hpp"
#include "breccia/virtual_test/homogenised_material.hpp"

namespace breccia {

/// How a quasi-static result was made.
struct QuasistaticRecord {
  QuasistaticResponse response;  ///< without its curves
  LinearEffort effort;           ///< of all loads together
  double seconds = 0.0;          ///< wall time, of all loads together
};

/// How far an extrapolated curve may be off, and from which grids it comes.
struct ExtrapolationRecord {
  std::vector<int> cells;          ///< per side, rising
  std::vector<double> half_bands;  ///< of the modulus at each time [Pa]
};

/// Fields of a test, as they are in the directory of its stage.
struct FieldRecord {
  double time = 0.0;  ///< [s]
  std::string file;   ///< VTKHDF
  std::string stress_picture, strain_picture;
};

/// One virtual test of one stage under one load, done.
struct TestResult {
  Load load = Load::shear;
  Boundary boundary = Boundary::displacement;
  Method method = Method::quasistatic;
  int cells = 0;            ///< per side; 0: extrapolated
  Curve modulus = {};       ///< relaxation modulus; of a creep test after interconversion
  Creep compliance = {};    ///< of a creep test
  PronySeries series = {};  ///< of the modulus
  std::vector<FieldRecord> fields = {};
  std::variant<QuasistaticRecord, DynamicTestResult, ExtrapolationRecord> record = {};
};

/// The result of a stage under one boundary and by one method, as a material.
struct StageMaterial {
  Boundary boundary = Boundary::displacement;
  Method method = Method::quasistatic;
  HomogenisedMaterial result = {};
};

/// A computed modulus beside a measured one.
struct ComparedSample {
  double time = 0.0;      ///< [s]
  double modulus = 0.0;   ///< computed [Pa]
  double measured = 0.0;  ///< [Pa]

  [[nodiscard]] double ratio() const { return modulus / measured; }
};

/// G(t) of a stage under one boundary and by one method beside a measurement.
struct Comparison {
  std::string measurement;  ///< its label
  Boundary boundary = Boundary::displacement;
  Method method = Method::quasistatic;
  int cells = 0;                        ///< per side; 0: extrapolated
  std::vector<ComparedSample> samples;  ///< at the times of the curve, at least one

  /// Where the ratio is nearest to one, and where it is furthest.
  [[nodiscard]] const ComparedSample& best() const;
  [[nodiscard]] const ComparedSample& worst() const;
};

/// One stage, done as far as `tests` tell.
struct StageResult {
  std::string name;
  int cells = 0;
  std::size_t points = 0;
  double point_fraction = 0.0;  ///< share of the material points that are filler [-]
  StageMicrostructure microstructure;
  std::vector<TestResult> tests;
  std::vector<StageMaterial> materials;  ///< what later stages take as their matrix
  std::vector<Comparison> comparisons;   ///< with all that was measured
  std::vector<std::string> warnings;     ///< what makes the results doubtful
  /// The task of a sweep whose reduced responses gave the tests at another temperature; empty where they were computed.
  std::string answered_from = {};
};

struct StudyResult {
  std::vector<StageResult> stages;
  std::optional<double> seconds = {};  ///< wall time, once everything is done and written
};

/// Those who follow a running study. What they throw ends it.
struct StudyObserver {
  std::function<void(const Stage&, const PackingProgress&)> packing = {};
  std::function<void(const Stage&, const StageResult&)> packed = {};
  std::function<void(const Stage&, const std::string& test, double share, const std::string& details)> progress = {};
  std::function<void(const Stage&, const TestResult&)> finished = {};
  std::function<void(const Stage&, Boundary, Load, const TimeDomain&)> domain_finished = {};
  /// Told where results are written that take the place of earlier ones only when they are whole.
  std::function<void(const std::filesystem::path&)> writes_beside = {};
  /// Told of a stage that another task of a sweep has computed already, and where its files are.
  std::function<void(const StageResult&, const std::filesystem::path&)> taken_over = {};
  std::function<void(const std::string&)> noted = {};  ///< what a user should know of files that were found
};

/// How a study is run.
struct RunOptions {
  int threads = 0;                      ///< 0: all
  bool resume = false;                  ///< go on from the checkpoints of an earlier run
  bool overwrite = false;               ///< replace results of other studies, once the new ones are whole
  CheckpointSchedule checkpoints = {};  ///< when a calculation leaves its state, and when it ends early
  bool ignore_memory = false;           ///< begin even what will hardly fit
  /// Earlier results that may be replaced without `overwrite`: hashes of their records, as a sweep has found them.
  std::vector<std::string> replaceable = {};
};

/// Runs all stages and tests of a study and writes the results (docs/results.md) to a directory, which is made. Every
/// file appears whole or not at all. Where earlier results are in the directory, they stay until the new ones are
/// whole, which are written to its subdirectory `unfinished` meanwhile. What is done when the run ends early stays, and
/// with it checkpoints, from which another run goes on to the same bits. Throws InputError, also where it would replace
/// or go on from results of another study or version and is not to overwrite them, NumericalError, FileError or
/// Interrupted.
StudyResult run_study(const Study& study, const std::filesystem::path& directory, const RunOptions& options = {},
                      const StudyObserver& observer = {});

/// Packs the microstructures of a study alone and writes them, and checkpoints from which run_study goes on. Throws as
/// run_study does.
StudyResult pack_study(const Study& study, const std::filesystem::path& directory, const RunOptions& options = {},
                       const StudyObserver& observer = {});

/// A stage with its matrix and its microstructure on a grid, ready to be tested.
DynamicTest make_dynamic_test(const Study& study, const Stage& stage, const Material& matrix,
                              const Discretisation& discretisation, Boundary boundary, Load load, int threads);
QuasistaticTest make_quasistatic_test(const Study& study, const Stage& stage, const Material& matrix,
                                      const Discretisation& discretisation, Boundary boundary, int threads);

/// Does a later stage take the result of this one as its matrix?
bool serves_as_matrix(const Study& study, const Stage& stage);

/// The loads of a stage: those of the study, and shear and bulk where the result serves as a matrix.
std::vector<Load> loads_of(const Study& study, const Stage& stage);

/// A guess at the matrix of a stage before anything has been computed: exact where it is a material. It plans runs; no
/// result depends on it.
Material expected_matrix(const Study& study, const Stage& stage);

/// Cells per side of all grids of a stage, rising.
std::vector<int> grids_of(const Stage& stage);

/// The name of a material or stage.
const std::string& name_of(const StageMatrix& matrix);

/// What holds the box for a bound.
Boundary boundary_of(Bound bound);
/// The bound that a boundary gives.
Bound bound_under(Boundary boundary);

/// "shear", "shear-xx-yy" or "bulk", as in decks and results.
std::string name_of(Load load);
/// "displacement", "traction" or "periodic".
std::string name_of(Boundary boundary);
/// "quasistatic" or "dynamic".
std::string name_of(Method method);
/// "upper bound", "lower bound" or "periodic".
std::string bound_of(Boundary boundary);
/// "matrix" or "times".
std::string name_of(SampledRange range);
/// The cells per side of a grid as tables have them: a number, or "extrapolated" for 0.
std::string name_of_grid(int cells);

}  // namespace breccia
