#include "homogenisation/stage_materials.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "homogenisation/inclusions.hpp"
#include "homogenisation/run/stage_extrapolation.hpp"
#include "study/chain.hpp"
#include "virtual_test/bulk_test.hpp"

namespace breccia {
namespace {

void require_good_fit(const StageFit& fit, const StageMaterial& fitted) {
  const auto refuse = [&](std::string_view modulus, double error) {
    throw NumericalError(fmt::format(
        "stage {}, {}, {}: the fit of {}, on which later stages build, is up to {:.2g} % off its curve, more than "
        "tests.fit_tolerance = {:.2g} %; longer ramps or more overlap make dynamic curves smoother, finer cells "
        "extrapolations",
        fit.stage, name_of(fitted.boundary), name_of(fitted.method), modulus, 100.0 * error, 100.0 * fit.tolerance));
  };
  // A NaN fails this comparison, too.
  const auto& result = fitted.result;
  if (!(result.shear_error <= fit.tolerance)) refuse("G(t)", result.shear_error);
  if (!(result.bulk_error <= fit.tolerance)) refuse(formula_of_bulk_test(fit.dimensions), result.bulk_error);
}

StageFit fit_of(const Tests& tests, const Stage& stage) {
  return {.stage = stage.name,
          .side = stage.side,
          .dimensions = stage.dimensions(),
          .mixing = tests.mixing,
          .shear = shear_of_material(tests),
          .times = {tests.first_time, tests.last_time},
          .points_per_decade = tests.points_per_decade,
          .tolerance = tests.fit_tolerance};
}

}  // namespace

StageMaterial fitted_material(const StageFit& fit, const std::vector<TestResult>& tests, Boundary boundary,
                              Method method, double density) {
  // A response at one time depends on the moduli at all earlier times, the less the earlier they are: exact series are
  // evaluated from three decades earlier on.
  constexpr double back = 1e-3;
  const auto times = logarithmic_times({back * fit.times.begin, fit.times.end}, std::max(fit.points_per_decade, 20));
  const auto curve = [&](TestLoad load) {
    return curve_at(preferred_test(tests, load, boundary, method), fit.side, fit.dimensions, tests, fit.mixing, times);
  };
  StageMaterial material{
      boundary, method,
      homogenised_material(fit.stage, density, curve(fit.shear), curve(Load::bulk), fit.tolerance, fit.dimensions)};
  require_good_fit(fit, material);
  return material;
}

std::vector<StageMaterial> materials_from(const Study& study, const Stage& stage,
                                          const std::vector<StageResult>& earlier, const StageResult& result) {
  const auto fit = fit_of(study.tests, stage);
  const auto inclusions = inclusions_of(stage, result.microstructure.fillers);
  std::vector<StageMaterial> materials;
  for (const auto boundary : study.tests.boundaries) {
    for (const auto method : study.tests.methods) {
      const auto& matrix = matrix_of(stage.name, stage.matrix, earlier, boundary, method);
      const double density = density_with(inclusions, matrix.density);
      materials.push_back(fitted_material(fit, result.tests, boundary, method, density));
    }
  }
  return materials;
}

const Material& matrix_of(const std::string& stage, const StageMatrix& matrix, const std::vector<StageResult>& earlier,
                          Boundary boundary, Method method) {
  if (const auto* material = std::get_if<Material>(&matrix)) return *material;
  const auto& name = name_of(matrix);
  const auto made_by = std::ranges::find(earlier, name, &StageResult::name);
  if (made_by != earlier.end()) {
    for (const auto& material : made_by->materials) {
      if (material.boundary == boundary && material.method == method) return material.result.material;
    }
  }
  throw InputError(fmt::format("stage {}: stage {} has no result for the boundary {}, {}", stage, name,
                               name_of(boundary), name_of(method)));
}

}  // namespace breccia
