#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "breccia/homogenisation/stage_microstructure.hpp"
#include "breccia/homogenisation/stage_stiffness.hpp"
#include "breccia/quasistatic/linear_options.hpp"
#include "breccia/quasistatic/reduced_response.hpp"
#include "breccia/study/test_id.hpp"
#include "breccia/tables/modulus_kind.hpp"
#include "breccia/virtual_test/homogenised_material.hpp"
#include "breccia/virtual_test/test_fields.hpp"
#include "breccia/virtual_test/time_domain.hpp"
#include "breccia/words.hpp"

namespace breccia {

/// Record of the computation of a quasi-static result.
struct QuasistaticRecord {
  std::optional<ReducedResponse> reduced = {};  ///< reduced response; the reduced solver alone has one
  /// Largest relative deviation of the series from the time steps [-]; of the stepping solver alone.
  std::optional<double> fit_error = {};
  LinearEffort effort = {};  ///< cost of the linear systems of all loads together
};

/// Record of the computation of a dynamic result.
struct DynamicRecord {
  std::vector<TimeDomain> domains = {};
  std::vector<Overlap> overlaps = {};  ///< overlaps of neighbouring domains, in the order of the domains
  /// Error of the fit by which a compliance is converted [-] (DynamicTestResult).
  std::optional<double> fit_error = {};
};

/// Record of the extrapolation of a curve to vanishing cells.
struct ExtrapolationRecord {
  std::vector<int> cells = {};  ///< cells per side of the grids, rising
};

/// Record of a mean of the curves of several tests, which differ only in their loads.
struct MeanRecord {
  std::vector<Load> loads = {};
};

/// The error of a modulus by its causes, each as a share of the modulus [-]; nothing where it is not known.
struct ModulusError {
  std::optional<double> grid = {};    ///< of the cells: measured by several grids, or to be expected of one by a rule
  std::optional<double> sample = {};  ///< of a box that holds few particles, by a rule (theory, Eq. 43h)
  std::optional<double> solver = {};  ///< of the reduced basis, or of the time steps
  /// Of an earlier stage that is the matrix: its whole error, which changes the modulus by this share at most; 0 where
  /// the matrix is a material.
  std::optional<double> matrix = {};

  /// The root of the sum of the squares of all causes [-]; nothing where one of them is not known.
  [[nodiscard]] std::optional<double> whole() const;
};

/// The largest whole error of a list [-]; nothing where one is not known, and for an empty list.
[[nodiscard]] std::optional<double> largest_whole(const std::vector<ModulusError>& errors);

/// A complex modulus at an angular frequency, and its error.
struct ComplexSample {
  double angular_frequency = 0.0;    ///< [rad/s]
  double storage = 0.0;              ///< [Pa]
  double loss = 0.0;                 ///< [Pa]
  std::optional<double> error = {};  ///< whole error of the relaxation modulus at the time 1/omega, over it [-]
};

/// The result of one virtual test of one stage under one load: its curves and their errors, and a record of the
/// computation.
struct TestResult {
  TestId id;
  Curve modulus = {};       ///< relaxation modulus; for a creep test by interconversion
  Creep compliance = {};    ///< creep compliance, for a creep test only
  PronySeries series = {};  ///< relaxation modulus
  /// Largest estimated relative error of the reduced basis, over its training set, or of the time steps [-]; NaN where
  /// it is unknown.
  double error_estimate = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> half_bands = {};  ///< half width of the error band of an extrapolated modulus at each time [Pa]
  /// The error of the modulus at each time, once all tests of the stage are done; empty for a test that is not the
  /// preferred one of its load, boundary and method.
  std::vector<ModulusError> errors = {};
  /// The complex modulus at the frequencies of a study whose deck gives frequencies, rising, once all tests of the
  /// stage are done; else empty.
  std::vector<ComplexSample> in_frequency = {};
  /// Wall time [s], of a quasi-static test that of all loads together; nothing for extrapolated curves.
  std::optional<double> seconds = {};
  TestFields fields = {};  ///< fields; without times where a sink has stored them
  /// Record of the computation; std::monostate where it is not known, as in results that were read from files.
  std::variant<std::monostate, QuasistaticRecord, DynamicRecord, ExtrapolationRecord, MeanRecord> record = {};
};

/// The test under a load and a boundary on the preferred grid (is_preferred); nullptr if there is no such test.
const TestResult* find_preferred_test(const std::vector<TestResult>& tests, TestLoad load, Boundary boundary,
                                      Method method = Method::quasistatic);
/// As find_preferred_test(), but throws InputError if there is no such test.
const TestResult& preferred_test(const std::vector<TestResult>& tests, TestLoad load, Boundary boundary,
                                 Method method = Method::quasistatic);

/// The result of a stage under one boundary and by one method, as a material.
struct StageMaterial {
  Boundary boundary = Boundary::displacement;
  Method method = Method::quasistatic;
  HomogenisedMaterial result = {};
};

/// A computed and a measured modulus at the same time.
struct ComparedSample {
  double time = 0.0;      ///< [s]
  double modulus = 0.0;   ///< computed [Pa]
  double measured = 0.0;  ///< [Pa]
  /// Whole error of the computed modulus, over it [-]; nothing where it is not known.
  std::optional<double> error = {};

  [[nodiscard]] double ratio() const { return modulus / measured; }
};

/// A computed and a measured complex modulus at the same frequency.
struct ComparedComplexSample {
  double angular_frequency = 0.0;                      ///< [rad/s]
  double storage = 0.0, loss = 0.0;                    ///< computed [Pa]
  double measured_storage = 0.0, measured_loss = 0.0;  ///< [Pa]
  /// Whole error of the computed relaxation modulus at the time 1/omega, over it [-]; nothing where it is not known.
  std::optional<double> error = {};

  /// The ratio of the absolute values.
  [[nodiscard]] double ratio() const;
  /// The computed phase minus the measured one [rad].
  [[nodiscard]] double phase_difference() const;
};

/// Comparison of a modulus of a stage, under one boundary and by one method, with a measurement. There is a sample in
/// time or in frequency at least.
struct Comparison {
  std::string measurement;              ///< label of the measurement
  TestId test;                          ///< the preferred one of its boundary and method, in shear or, for K, in bulk
  std::vector<ComparedSample> samples;  ///< the relaxation modulus at the times of the curve
  /// The complex modulus at rising frequencies: those that were measured or else, of a measured series, those of the
  /// study.
  std::vector<ComparedComplexSample> in_frequency = {};
  ModulusKind kind = ModulusKind::shear;  ///< the modulus that was measured: G, K, or E

  /// The samples whose ratios are nearest to one and furthest from one, of those in time or in frequency; nullptr where
  /// there are none.
  [[nodiscard]] const ComparedSample* best() const;
  [[nodiscard]] const ComparedSample* worst() const;
  [[nodiscard]] const ComparedComplexSample* best_in_frequency() const;
  [[nodiscard]] const ComparedComplexSample* worst_in_frequency() const;
};

/// The linear thermal expansion of a stage at a time after a step of the temperature.
struct ExpansionSample {
  double time = 0.0;                 ///< [s]
  double expansion = 0.0;            ///< [1/K]
  std::optional<double> error = {};  ///< from that of the bulk moduli [1/K]; nothing where one of them is not known
};

/// The linear thermal expansion of a stage under one boundary and by one method, by Levin's equation.
struct StageExpansion {
  TestId test;  ///< the preferred test in bulk of its boundary and method
  std::vector<ExpansionSample> samples = {};
};

/// The kind of sample that a box is of its material, on which the scatter from box to box depends.
enum class SampleKind {
  whole,      ///< a regular array, or a box without particles: another box of the same make has the same moduli
  particles,  ///< random particles in a matrix
  grains,     ///< random grains that fill the box
  unknown     ///< an image, or listed particles
};

template <>
inline constexpr auto words<SampleKind> = std::to_array<Word<SampleKind>>({{"whole", SampleKind::whole},
                                                                           {"particles", SampleKind::particles},
                                                                           {"grains", SampleKind::grains},
                                                                           {"unknown", SampleKind::unknown}});

/// The rules for those errors of a stage's moduli that its curves do not show.
struct ErrorRules {
  /// Error of a single grid, or of grains and films [-]; nothing where no rule holds, and for several grids.
  std::optional<double> one_grid = {};
  SampleKind sample = SampleKind::unknown;
  double effective_particles = 0.0;  ///< number by which the scatter is estimated (theory, Eq. 43h)
};

/// What is known of the accuracy of a stage's moduli. The error of each modulus is in TestResult::errors.
struct StageAccuracy {
  std::string summary = {};               ///< in words; empty for a box without particles
  std::optional<double> grid_error = {};  ///< largest error of several grids [-]; nothing for one, and for films
  ErrorRules rules = {};
};

/// The results of the tests of one stage so far.
struct StageFindings {
  std::string name;
  int cells = 0;
  int dimensions = 2;      ///< dimensions of the box
  std::size_t points = 0;  ///< number of material points of the finest grid; 0 where films are computed without cells
  double point_fraction = 0.0;  ///< share of the material points, or of the box, that is filler [-]
  std::vector<TestResult> tests;
  std::vector<StageMaterial> materials;  ///< the stage as a material, for later stages
  std::vector<Comparison> comparisons;   ///< comparisons with all measurements of the stage
  /// The thermal expansion for each boundary and method where the deck gives those of the materials and the bulk moduli
  /// determine it.
  std::vector<StageExpansion> expansions = {};
  std::vector<StageStiffness> stiffness = {};  ///< the whole stiffness for each boundary where the deck asks for it
  StageAccuracy accuracy = {};                 ///< of the complete stage
  std::vector<std::string> warnings;           ///< reasons to doubt the results
};

/// The results of one stage that was computed.
struct StageResult : StageFindings {
  StageMicrostructure microstructure;
};

/// The results of a study.
struct StudyResult {
  std::vector<StageResult> stages;
  std::optional<double> seconds = {};  ///< wall time, once all stages are done
  std::string study_hash = {};         ///< hash of the study that was solved (provenance_of)
};

}  // namespace breccia
