#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "breccia/homogenisation/stage_microstructure.hpp"
#include "breccia/study/test_id.hpp"
#include "breccia/virtual_test/dynamic_test.hpp"
#include "breccia/virtual_test/homogenised_material.hpp"
#include "breccia/virtual_test/quasistatic_test.hpp"

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

/// One virtual test of one stage under one load, done.
struct TestResult {
  TestId id;
  Curve modulus = {};                       ///< relaxation modulus; of a creep test after interconversion
  Creep compliance = {};                    ///< of a creep test
  PronySeries series = {};                  ///< of the modulus
  std::vector<TimedFields<2>> fields = {};  ///< of the material points; empty where a sink has taken them
  std::variant<QuasistaticRecord, DynamicTestResult, ExtrapolationRecord> record = {};
};

/// The test under a load and a boundary that stands for all grids (is_preferred); null where there is none.
const TestResult* find_preferred_test(const std::vector<TestResult>& tests, Load load, Boundary boundary,
                                      Method method = Method::quasistatic);
/// The same; throws InputError where there is no such test.
const TestResult& preferred_test(const std::vector<TestResult>& tests, Load load, Boundary boundary,
                                 Method method = Method::quasistatic);

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
  std::string measurement;              ///< its label
  TestId test;                          ///< the one that stands for its boundary and method
  std::vector<ComparedSample> samples;  ///< at the times of the curve, at least one

  /// Where the ratio is nearest to one, and where it is furthest.
  [[nodiscard]] const ComparedSample& best() const;
  [[nodiscard]] const ComparedSample& worst() const;
};

/// The results of one stage, of those of its tests that are done.
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
};

struct StudyResult {
  std::vector<StageResult> stages;
  std::optional<double> seconds = {};  ///< wall time, once all stages are done
  std::string study_hash = {};         ///< of the study that was solved (provenance_of)
};

}  // namespace breccia
