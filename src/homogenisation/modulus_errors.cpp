#include "homogenisation/modulus_errors.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <variant>

#include "breccia/study/test_load.hpp"

#include "homogenisation/plan/grid_error.hpp"
#include "homogenisation/sample_error.hpp"
#include "homogenisation/stage_materials.hpp"
#include "study/test_rules.hpp"
#include "virtual_test/bulk_test.hpp"

namespace breccia {
namespace {

/// The modulus of a material under a load [Pa].
double modulus_under(TestLoad load, const Material& material, int dimensions, double time) {
  if (!load.is_bulk()) return material.shear.at(time);
  return material.bulk.at(time) + shear_in_bulk_test(dimensions) * material.shear.at(time);
}

/// The error of the grid of a test at one of its times; nothing where grids differ by as much as the modulus.
std::optional<double> grid_error(const TestResult& test, const ErrorRules& rules, std::size_t sample) {
  if (test.half_bands.empty()) return rules.one_grid;
  const double error = test.half_bands[sample] / test.modulus[sample].modulus;
  return error < 1.0 ? std::optional(error) : std::nullopt;
}

SampleKind sample_of(const Stage& stage) {
  if (stage.fillers.empty() || stage.packing_name() == PackingName::regular) return SampleKind::whole;
  if (!stage.has_seed()) return SampleKind::unknown;
  return stage.has_grains() ? SampleKind::grains : SampleKind::particles;
}

/// The error of a box in place of all boxes of its make.
std::optional<double> error_of_box(const ErrorRules& rules, const TestId& test, int dimensions, double stiffening) {
  // The rule was measured with periodic boxes.
  if (rules.sample != SampleKind::whole && test.boundary != Boundary::periodic) return std::nullopt;
  return sample_error(rules, dimensions, test.load, stiffening);
}

/// How far the two shears of a box of the plane are apart, up to each time at most [-]; empty for a test that is not
/// their mean.
std::vector<double> distances_of_shears(const StageFindings& stage, const TestId& mean) {
  std::vector<double> distances;
  if (!mean.load.is_isotropic() || !is_plane_strain(stage.dimensions)) return distances;
  const auto of = [&](Load load) { return find_preferred_test(stage.tests, load, mean.boundary, mean.method); };
  const auto *one = of(Load::shear), *other = of(Load::diagonal_shear);
  if (one == nullptr || other == nullptr || one->modulus.size() != other->modulus.size()) return distances;
  double largest = 0.0;
  for (std::size_t i = 0; i < one->modulus.size(); ++i) {
    largest = std::max(largest, std::abs(std::log(one->modulus[i].modulus / other->modulus[i].modulus)));
    distances.push_back(largest);
  }
  return distances;
}

/// The error of the solver on the finest grid; nothing where it is not known, as with the dynamic method.
std::optional<double> solver_error(const TestResult& preferred, const std::vector<TestResult>& tests) {
  const TestResult* finest = nullptr;
  for (const auto& test : tests) {
    auto id = preferred.id;
    id.grid = test.id.grid;
    if (test.id == id && !test.id.grid.is_extrapolated() && (finest == nullptr || finest->id.grid < test.id.grid)) {
      finest = &test;
    }
  }
  if (finest == nullptr || !std::isfinite(finest->error_estimate)) return std::nullopt;
  return finest->error_estimate;
}

/// The largest whole error at a time of the moduli of the stage that is the matrix; 0 where that is a material. The
/// modulus of a composite is of first degree in all moduli of its phases and grows with each, so that no share of error
/// in those of the matrix grows in it.
class MatrixError {
 public:
  MatrixError(const StageMatrix& matrix, const std::vector<StageResult>& earlier, const TestId& test) {
    const auto* const stage = std::get_if<EarlierStage>(&matrix);
    if (stage == nullptr) return;
    const auto found = std::ranges::find(earlier, stage->name, &StageResult::name);
    if (found == earlier.end()) return;
    is_material_ = false;
    const bool has_mean = std::ranges::any_of(found->tests, [](const auto& one) { return one.id.load.is_isotropic(); });
    for (const auto& one : found->tests) {
      if (one.errors.empty() || one.id.boundary != test.boundary || one.id.method != test.method) continue;
      if (has_mean && is_in_mean(one.id.load, found->dimensions)) continue;
      tests_.push_back(&one);
    }
  }

  [[nodiscard]] std::optional<double> at(double time) const {
    std::optional<double> largest = is_material_ ? std::optional(0.0) : std::nullopt;
    for (const auto* test : tests_) {
      const auto sample = std::ranges::find(test->modulus, time, &Sample::time);
      if (sample == test->modulus.end()) return std::nullopt;
      const auto error = test->errors[static_cast<std::size_t>(sample - test->modulus.begin())].whole();
      if (!error) return std::nullopt;
      largest = std::max(largest.value_or(0.0), *error);
    }
    return largest;
  }

 private:
  bool is_material_ = true;
  std::vector<const TestResult*> tests_ = {};
};

}  // namespace

ErrorRules error_rules_of(const Study& study, const Stage& stage, const StageMicrostructure& packed) {
  ErrorRules rules;
  const bool is_on_one_grid = model_of(study.tests, stage) != Model::films && stage.grids().size() == 1;
  const auto grid = is_on_one_grid ? plan_of_grid(study, stage, packed) : std::nullopt;
  if (grid) rules.one_grid = grid->error();
  rules.sample = sample_of(stage);
  rules.effective_particles = packed.effective_particles;
  return rules;
}

void add_errors(StageFindings& stage, const ErrorRules& rules, const StageMatrix& matrix,
                const std::vector<StageResult>& earlier) {
  for (auto& test : stage.tests) {
    test.errors.clear();
    const auto& id = test.id;
    if (find_preferred_test(stage.tests, id.load, id.boundary, id.method) != &test) continue;
    const auto solver = solver_error(test, stage.tests);
    const MatrixError of_matrix(matrix, earlier, id);
    const auto distances = distances_of_shears(stage, id);
    const auto& material = matrix_of(stage.name, matrix, earlier, id.boundary, id.method);
    for (std::size_t i = 0; i < test.modulus.size(); ++i) {
      const auto& [time, modulus] = test.modulus[i];
      const double stiffening = modulus / modulus_under(id.load, material, stage.dimensions, time);
      auto sample = error_of_box(rules, id, stage.dimensions, stiffening);
      if (sample && distances.size() == test.modulus.size()) {
        sample = std::min(*sample, sample_error_of_shears(distances[i]));
      }
      test.errors.push_back(
          {.grid = grid_error(test, rules, i), .sample = sample, .solver = solver, .matrix = of_matrix.at(time)});
    }
  }
}

}  // namespace breccia
