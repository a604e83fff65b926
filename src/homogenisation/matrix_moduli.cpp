#include "matrix_moduli.hpp"

#include <algorithm>

#include "breccia/quasistatic/carson_path.hpp"
#include "breccia/virtual_test/extrapolation.hpp"

namespace breccia {
namespace {

/// The reduced responses of a stage under one load and boundary, on one grid or on several grids for extrapolation.
struct ResponsesOnGrids {
  std::vector<double> cell_sides;  ///< falling [m]
  std::vector<const ReducedResponse*> responses;

  /// Modulus of the composite [Pa]; for several grids the limit of vanishing cells.
  [[nodiscard]] double modulus(const Moduli& matrix) const {
    std::vector<double> values;
    for (const auto* response : responses) values.push_back(response->modulus(matrix));
    return values.size() == 1 ? values.front() : extrapolate(cell_sides, values).value;
  }
};

ResponsesOnGrids responses_on_grids(const Stage& stage, const StageResult& result, Mixing mixing, Load load,
                                    Boundary boundary) {
  ResponsesOnGrids found;
  // With mixed cells the finest grid gives the results (theory, section 11).
  const auto grids = mixing == Mixing::series ? std::vector{stage.cells} : stage.grids();
  for (const int cells : grids) {
    for (const auto& test : result.tests) {
      const auto* record = std::get_if<QuasistaticRecord>(&test.record);
      if (test.id.load != load || test.id.boundary != boundary || test.id.grid != TestGrid(cells)) continue;
      if (record == nullptr || !record->response.reduced) continue;
      found.cell_sides.push_back(stage.side / cells);
      found.responses.push_back(&*record->response.reduced);
    }
  }
  return found;
}

/// Moduli [Pa] of a stage as an isotropic material in the plane (theory, Eq. 32) along a path of moduli of its matrix,
/// as long as they fall and are positive.
std::vector<Moduli> moduli_of_stage(const ResponsesOnGrids& in_shear, const ResponsesOnGrids& in_bulk,
                                    const std::vector<Moduli>& path) {
  constexpr double rounding = 1e-6;
  std::vector<Moduli> moduli;
  double last_shear = 0.0, last_bulk = 0.0;
  for (const auto& matrix : path) {
    const double shear = in_shear.modulus(matrix), plane_bulk = in_bulk.modulus(matrix);
    const double bulk = plane_bulk - shear / 3.0;
    const bool falls =
        moduli.empty() || (shear <= (1.0 + rounding) * last_shear && plane_bulk <= (1.0 + rounding) * last_bulk);
    if (!(shear > 0.0) || !(bulk > 0.0) || !falls) break;
    moduli.push_back({bulk, shear});
    last_shear = shear;
    last_bulk = plane_bulk;
  }
  return moduli;
}

}  // namespace

std::vector<Moduli> matrix_moduli(const Study& study, const Stage& stage, const std::vector<StageResult>& earlier,
                                  Boundary boundary) {
  if (const auto* material = std::get_if<Material>(&stage.matrix)) {
    return relaxation_path(*material, {study.tests.first_time, study.tests.last_time});
  }
  const auto& name = std::get<EarlierStage>(stage.matrix).name;
  const auto made_by = std::ranges::find(study.stages, name, &Stage::name);
  const auto made = std::ranges::find(earlier, name, &StageResult::name);
  if (made_by == study.stages.end() || made == earlier.end()) return {};
  const auto in_shear = responses_on_grids(*made_by, *made, study.tests.mixing, Load::shear, boundary);
  const auto in_bulk = responses_on_grids(*made_by, *made, study.tests.mixing, Load::bulk, boundary);
  if (in_shear.responses.empty() || in_bulk.responses.empty()) return {};
  return moduli_of_stage(in_shear, in_bulk, matrix_moduli(study, *made_by, earlier, boundary));
}

}  // namespace breccia
