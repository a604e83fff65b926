#include "homogenisation/modulus_errors.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <variant>

#include "breccia/study/test_load.hpp"

#include "discretisation/contrast.hpp"
#include "homogenisation/narrow_gaps.hpp"
#include "homogenisation/plan/film_error.hpp"
#include "homogenisation/plan/grid_error.hpp"
#include "homogenisation/run/isotropic_mean.hpp"
#include "homogenisation/run/test_requests.hpp"
#include "homogenisation/sample_error.hpp"
#include "homogenisation/stage_materials.hpp"
#include "study/chain.hpp"
#include "study/coatings.hpp"
#include "study/test_rules.hpp"
#include "virtual_test/bulk_test.hpp"

namespace breccia {
namespace {

/// The error of the grid of a test at one of its times; nothing where grids differ by as much as the modulus.
std::optional<double> grid_error(const TestResult& test, const ErrorRules& rules, std::size_t sample) {
  // The rule for one grid, or for films, is that of the quasi-static method.
  if (test.half_bands.empty()) return test.id.method == Method::quasistatic ? rules.one_grid : std::nullopt;
  const double error = test.half_bands[sample] / test.modulus[sample].modulus;
  return error < 1.0 ? std::optional(error) : std::nullopt;
}

/// Whether the fillers have a rule for the scatter: all stiffer than the matrix, or particles that are all softer, and
/// neither coatings nor crystals. Others may hardly stiffen the matrix, and scatter nevertheless.
bool has_fillers_with_rule(const Study& study, const Stage& stage) {
  if (thinnest_coating(stage) || stage.has_crystals()) return false;
  if (are_stiffer_than_matrix(materials_of(stage, expected_matrix(study, stage)))) return true;
  return has_soft_fillers(study, stage) && !stage.has_grains();
}

/// The largest distance |ln (G_xy / G_xx-yy)| of the two shears of a box of the plane up to each time [-]; empty for a
/// test that is not their mean.
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

/// The largest error up to a time of the moduli of the stage that is the matrix, with the error of the series that
/// stands for them; 0 where the matrix is a material. The modulus of a composite is of first degree in all moduli of
/// its phases and grows with each, so that a share of error in those of the matrix is no larger in it.
class MatrixError {
 public:
  MatrixError(const StageMatrix& matrix, const std::vector<StageResult>& earlier, const TestId& test) {
    const auto* const stage = std::get_if<EarlierStage>(&matrix);
    if (stage == nullptr) return;
    const auto found = std::ranges::find(earlier, stage->name, &StageResult::name);
    if (found == earlier.end()) return;
    is_material_ = false;
    for (const auto& [boundary, method, fit] : found->materials) {
      if (boundary == test.boundary && method == test.method) fit_ = std::max(fit.shear_error, fit.bulk_error);
    }
    for (const auto& one : found->tests) {
      if (one.errors.empty() || one.id.boundary != test.boundary || one.id.method != test.method) continue;
      if (is_replaced_by_mean(one.id, found->dimensions, found->tests)) continue;
      tests_.push_back(&one);
    }
  }

  [[nodiscard]] std::optional<double> at(double time) const {
    if (is_material_) return 0.0;
    std::optional<double> largest;
    for (const auto* test : tests_) {
      const auto end = std::ranges::find(test->modulus, time, &Sample::time);
      if (end == test->modulus.end()) return std::nullopt;
      const auto samples = static_cast<std::size_t>(end - test->modulus.begin()) + 1;
      for (std::size_t i = 0; i < samples; ++i) {
        const auto error = test->errors[i].whole();
        if (!error) return std::nullopt;
        largest = std::max(largest.value_or(0.0), *error);
      }
    }
    return largest ? std::optional(std::hypot(*largest, fit_)) : std::nullopt;
  }

 private:
  bool is_material_ = true;
  double fit_ = 0.0;  ///< error of the series [-]
  std::vector<const TestResult*> tests_ = {};
};

}  // namespace

SampleKind sample_of(const Study& study, const Stage& stage, const StageMicrostructure& packed) {
  if (stage.fillers.empty() || stage.packing_name() == PackingName::regular) return SampleKind::whole;
  if (!stage.has_seed() || !has_fillers_with_rule(study, stage)) return SampleKind::unknown;
  if (stage.dimensions() == 3 && packed.content<Microstructure<3>>() == nullptr) return SampleKind::unknown;
  // The rule was measured with grains that are all bonded.
  if (stage.bonds) return SampleKind::unknown;
  return stage.has_grains() ? SampleKind::grains : SampleKind::particles;
}

ErrorRules error_rules_of(const Study& study, const Stage& stage, const StageMicrostructure& packed) {
  ErrorRules rules;
  const bool is_on_one_grid = model_of(study.tests, stage) != Model::films && stage.grids().size() == 1;
  const auto grid = is_on_one_grid ? plan_of_grid(study, stage, packed) : std::nullopt;
  rules.one_grid = grid ? grid->error() : film_error(study, stage, packed);
  rules.sample = sample_of(study, stage, packed);
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
      const Moduli matrix_then = {.bulk = material.bulk.at(time), .shear = material.shear.at(time)};
      const double stiffening = modulus / modulus_under(id.load, matrix_then, stage.dimensions);
      auto sample = sample_error(rules, stage.dimensions, id.boundary, id.load, stiffening);
      if (sample && stiffening > 1.0 && distances.size() == test.modulus.size()) {
        sample = narrowed_by_shears(*sample, distances[i]);
      }
      test.errors.push_back(
          {.grid = grid_error(test, rules, i), .sample = sample, .solver = solver, .matrix = of_matrix.at(time)});
    }
  }
}

}  // namespace breccia
