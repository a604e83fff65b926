#include "breccia/homogenisation/stage_materials.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/virtual_test/bulk_test.hpp"

#include "inclusions.hpp"
#include "stage_extrapolation.hpp"

namespace breccia {
namespace {

void require_good_fit(const Study& study, const Stage& stage, const StageMaterial& fitted) {
  const auto refuse = [&](std::string_view modulus, double error) {
    throw NumericalError(fmt::format(
        "stage {}, {}, {}: the fit of {}, on which later stages build, is up to {:.2g} % off its curve, more than "
        "tests.fit_tolerance = {:.2g} %; longer ramps or more overlap make dynamic curves smoother, finer cells "
        "extrapolations",
        stage.name, bound_of(fitted.boundary), name_of(fitted.method), modulus, 100.0 * error,
        100.0 * study.tests.fit_tolerance));
  };
  // A NaN fails this comparison, too.
  const auto& result = fitted.result;
  if (!(result.shear_error <= study.tests.fit_tolerance)) refuse("G(t)", result.shear_error);
  if (!(result.bulk_error <= study.tests.fit_tolerance)) {
    refuse(formula_of_bulk_test(stage.dimensions()), result.bulk_error);
  }
}

}  // namespace

const Material& matrix_of(const Stage& stage, const std::vector<StageResult>& earlier, Boundary boundary,
                          Method method) {
  if (const auto* material = std::get_if<Material>(&stage.matrix)) return *material;
  const auto& name = std::get<EarlierStage>(stage.matrix).name;
  const auto made_by = std::ranges::find(earlier, name, &StageResult::name);
  if (made_by != earlier.end()) {
    for (const auto& material : made_by->materials) {
      if (material.boundary == boundary && material.method == method) return material.result.material;
    }
  }
  throw InputError(fmt::format("stage {}: stage {} has no result for the {}, {}", stage.name, name, bound_of(boundary),
                               name_of(method)));
}

std::vector<StageMaterial> materials_from(const Study& study, const Stage& stage,
                                          const std::vector<StageResult>& earlier, const StageResult& result) {
  // A response at one time depends on the moduli at all earlier times, the less the earlier they are: exact series are
  // evaluated from three decades earlier on.
  constexpr double back = 1e-3;
  const auto times = logarithmic_times({back * study.tests.first_time, study.tests.last_time},
                                       std::max(study.tests.points_per_decade, 20));
  std::vector<StageMaterial> materials;
  for (const auto boundary : study.tests.boundaries) {
    for (const auto method : study.tests.methods) {
      const auto curve = [&](Load load) {
        return curve_at(preferred_test(result.tests, load, boundary, method), stage, result.tests, study.tests.mixing,
                        times);
      };
      const auto& matrix = matrix_of(stage, earlier, boundary, method);
      const double density = density_with(inclusions_of(stage, result.microstructure.fillers), matrix.density);
      materials.push_back({boundary, method,
                           homogenised_material(stage.name, density, curve(Load::shear), curve(Load::bulk),
                                                study.tests.fit_tolerance, stage.dimensions())});
      require_good_fit(study, stage, materials.back());
    }
  }
  return materials;
}

}  // namespace breccia
