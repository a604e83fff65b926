#include "homogenisation/varying_moduli.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "homogenisation/varying_phases.hpp"
#include "quasistatic/reduced/carson_path.hpp"
#include "study/chain.hpp"
#include "virtual_test/bulk_test.hpp"
#include "virtual_test/extrapolation.hpp"

namespace breccia {
namespace {

/// The reduced responses of a stage under one load and boundary, on one grid or on several grids for extrapolation.
struct ResponsesUnderLoad {
  std::vector<double> cell_sides;  ///< sides of the cells, falling [m]
  std::vector<const ReducedResponse*> responses;

  /// Modulus of the composite [Pa]; for several grids the limit of vanishing cells.
  [[nodiscard]] double modulus(const std::vector<Moduli>& of_phases) const {
    std::vector<double> values;
    for (const auto* response : responses) values.push_back(response->modulus(of_phases));
    return values.size() == 1 ? values.front() : extrapolate(cell_sides, values).value;
  }
};

ResponsesUnderLoad responses_under(Load load, const Stage& stage, const StageResult& result, Mixing mixing,
                                   Boundary boundary) {
  ResponsesUnderLoad found;
  // With mixed cells the finest grid gives the results (theory, section 11).
  const auto grids = has_mixed_cells(mixing) ? std::vector{stage.cells} : stage.grids();
  for (const int cells : grids) {
    for (const auto& test : result.tests) {
      const auto* record = std::get_if<QuasistaticRecord>(&test.record);
      const bool is_on_grid = test.id.grid.is_films() || test.id.grid == TestGrid(cells);
      if (test.id.load != load || test.id.boundary != boundary || !is_on_grid) continue;
      if (record == nullptr || !record->reduced) continue;
      found.cell_sides.push_back(stage.side / cells);
      found.responses.push_back(&*record->reduced);
    }
  }
  return found;
}

/// The reduced responses of a stage whose mean is one of its moduli.
struct ResponsesOfModulus {
  std::vector<ResponsesUnderLoad> under_loads;
  Boundary boundary = Boundary::displacement;

  [[nodiscard]] bool are_known() const {
    return std::ranges::none_of(under_loads, [](const auto& under_load) { return under_load.responses.empty(); });
  }
  /// Mean modulus [Pa], under tractions that of the mean compliance (theory, Eqs. 13a and 13b).
  [[nodiscard]] double modulus(const std::vector<Moduli>& of_phases) const {
    const bool is_of_creep = boundary == Boundary::traction;
    double sum = 0.0;
    for (const auto& under_load : under_loads) {
      const double modulus = under_load.modulus(of_phases);
      sum += is_of_creep ? 1.0 / modulus : modulus;
    }
    const double mean = sum / static_cast<double>(under_loads.size());
    return is_of_creep ? 1.0 / mean : mean;
  }
};

ResponsesOfModulus responses_of_modulus(TestLoad load, const Stage& stage, const StageResult& result, Mixing mixing,
                                        Boundary boundary) {
  ResponsesOfModulus found{{}, boundary};
  const auto add = [&](Load one) {
    found.under_loads.push_back(responses_under(one, stage, result, mixing, boundary));
  };
  if (load.is_isotropic()) {
    std::ranges::for_each(isotropic_shears(stage.dimensions()), add);
  } else {
    add(*load.of_test());
  }
  return found;
}

/// Moduli [Pa] of a stage as an isotropic material (theory, Eq. 32) along a path of moduli of its phases that vary, as
/// long as they fall and are positive.
std::vector<Moduli> moduli_of_stage(const Stage& stage, const ResponsesOfModulus& in_shear,
                                    const ResponsesOfModulus& in_bulk, const std::vector<std::vector<Moduli>>& path) {
  constexpr double rounding = 1e-6;
  std::vector<Moduli> moduli;
  const double share_of_shear = shear_in_bulk_test(stage.dimensions());
  double last_shear = 0.0, last_bulk = 0.0;
  for (const auto& of_phases : path) {
    const double shear = in_shear.modulus(of_phases), tested = in_bulk.modulus(of_phases);
    const double bulk = tested - share_of_shear * shear;
    const bool falls =
        moduli.empty() || (shear <= (1.0 + rounding) * last_shear && tested <= (1.0 + rounding) * last_bulk);
    if (!(shear > 0.0) || !(bulk > 0.0) || !falls) break;
    moduli.push_back({bulk, shear});
    last_shear = shear;
    last_bulk = tested;
  }
  return moduli;
}

/// The varying phases of a stage and of the earlier stages that make up its matrix.
class ChainOfStages {
 public:
  ChainOfStages(const Study& study, const std::vector<StageResult>& earlier, Boundary boundary)
      : study_(study), earlier_(earlier), boundary_(boundary) {}

  /// The materials of all varying phases of the chain.
  [[nodiscard]] std::vector<Material> materials(const Stage& stage) const {
    std::vector<Material> materials;
    if (const auto* matrix = std::get_if<Material>(&stage.matrix)) {
      materials.push_back(*matrix);
    } else if (const auto* made_by = stage_below(stage)) {
      materials = this->materials(*made_by);
    }
    for (const auto& [phase, material] : other_varying_phases(study_.tests, stage)) materials.push_back(material);
    return materials;
  }

  /// Moduli [Pa] of the phases of the stage at Laplace variables [1/s], as far as the moduli of its matrix are known.
  [[nodiscard]] std::vector<std::vector<Moduli>> moduli(const Stage& stage,
                                                        const std::vector<double>& laplace_variables) const {
    const auto of_matrix = matrix_moduli(stage, laplace_variables);
    const auto others = other_varying_phases(study_.tests, stage);
    std::vector<std::vector<Moduli>> moduli;
    for (std::size_t i = 0; i < of_matrix.size(); ++i) {
      auto& point = moduli.emplace_back(std::vector{of_matrix[i]});
      for (const auto& [phase, material] : others) point.push_back(carson_moduli(material, laplace_variables[i]));
    }
    return moduli;
  }

 private:
  /// The earlier stage that is the matrix of a stage; null for a material, and for a stage that does not exist.
  [[nodiscard]] const Stage* stage_below(const Stage& stage) const {
    const auto* earlier = std::get_if<EarlierStage>(&stage.matrix);
    if (earlier == nullptr) return nullptr;
    const auto made_by = std::ranges::find(study_.stages, earlier->name, &Stage::name);
    return made_by == study_.stages.end() ? nullptr : &*made_by;
  }

  [[nodiscard]] std::vector<Moduli> matrix_moduli(const Stage& stage,
                                                  const std::vector<double>& laplace_variables) const {
    if (const auto* material = std::get_if<Material>(&stage.matrix)) {
      std::vector<Moduli> moduli;
      moduli.reserve(laplace_variables.size());
      for (const double s : laplace_variables) moduli.push_back(carson_moduli(*material, s));
      return moduli;
    }
    const auto* made_by = stage_below(stage);
    if (made_by == nullptr) return {};
    const auto made = std::ranges::find(earlier_, made_by->name, &StageResult::name);
    if (made == earlier_.end()) return {};
    const auto responses = [&](TestLoad load) {
      return responses_of_modulus(load, *made_by, *made, study_.tests.mixing, boundary_);
    };
    const auto in_shear = responses(shear_of_material(study_.tests)), in_bulk = responses(Load::bulk);
    if (!in_shear.are_known() || !in_bulk.are_known()) return {};
    return moduli_of_stage(*made_by, in_shear, in_bulk, moduli(*made_by, laplace_variables));
  }

  const Study& study_;
  const std::vector<StageResult>& earlier_;
  Boundary boundary_;
};

}  // namespace

std::vector<std::vector<Moduli>> varying_moduli(const Study& study, const Stage& stage,
                                                const std::vector<StageResult>& earlier, Boundary boundary) {
  const auto materials = ChainOfStages(study, earlier, boundary).materials(stage);
  std::vector<double> laplace_variables;
  for (const auto& point : relaxation_path(materials, {study.tests.first_time, study.tests.last_time})) {
    laplace_variables.push_back(point.laplace_variable);
  }
  std::vector<std::vector<Moduli>> moduli;
  for (const auto& choice : choices_of_varied(study.tests.varied, materials)) {
    auto variant = study;
    for (auto& one : variant.stages) one = with_materials(std::move(one), choice);
    const auto path =
        ChainOfStages(variant, earlier, boundary).moduli(with_materials(stage, choice), laplace_variables);
    moduli.insert(moduli.end(), path.begin(), path.end());
  }
  return moduli;
}

}  // namespace breccia
