#include "homogenisation/plan/expected_sample_error.hpp"

#include <algorithm>
#include <cstddef>

#include "breccia/virtual_test/curve.hpp"

#include "homogenisation/plan/expected_moduli.hpp"
#include "homogenisation/sample_error.hpp"
#include "study/chain.hpp"

namespace breccia {
namespace {

/// The loads whose moduli are results: those of the study and those of the stage as a material; of the whole stiffness
/// each shear by itself.
std::vector<TestLoad> reported_loads(const Study& study, const Stage& stage) {
  auto loads = study.tests.loads;
  if (serves_as_matrix(study.stages, stage.name)) {
    loads.push_back(shear_of_material(study.tests));
    loads.emplace_back(Load::bulk);
  }
  if (study.tests.whole_stiffness) {
    const auto shears = isotropic_shears(stage.dimensions());
    loads.insert(loads.end(), shears.begin(), shears.end());
  }
  return loads;
}

/// A stage whose fillers have the fractions of its packed box, which a deck need not give.
Stage with_fractions(Stage stage, const std::vector<FillerStatistics>& fillers) {
  for (std::size_t number = 0; number < std::min(stage.fillers.size(), fillers.size()); ++number) {
    stage.fillers[number].fraction = fillers[number].fraction;
  }
  return stage;
}

}  // namespace

std::optional<double> expected_sample_error(const Study& study, const Stage& stage,
                                            const std::vector<FillerStatistics>& fillers, const ErrorRules& rules) {
  const auto packed = with_fractions(stage, fillers);
  const int dimensions = stage.dimensions();
  double largest = 0.0;
  for (const double time : logarithmic_times({study.tests.first_time, study.tests.last_time}, 1)) {
    const auto matrix = expected_moduli_of_matrix(study, stage, time), composite = expected_moduli(study, packed, time);
    for (const auto load : reported_loads(study, stage)) {
      const double stiffening = modulus_under(load, composite, dimensions) / modulus_under(load, matrix, dimensions);
      for (const auto boundary : study.tests.boundaries) {
        const auto error = sample_error(rules, dimensions, boundary, load, stiffening);
        if (!error) return std::nullopt;
        largest = std::max(largest, *error);
      }
    }
  }
  return largest;
}

}  // namespace breccia
