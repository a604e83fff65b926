#include "homogenisation/run/stage_expansions.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/viscoelasticity/thermal_expansion.hpp"

#include "homogenisation/stage_materials.hpp"
#include "study/chain.hpp"
#include "study/expansion_rules.hpp"

namespace breccia {
namespace {

double expansion_of(const Study& study, const Material& material) {
  if (is_void(material)) return 0.0;
  return *find_material(study.materials, material.name)->thermal_expansion;
}

/// What a stage adds to the expansion of its matrix, where it has a filler.
std::optional<ExpandingFiller> filler_of(const Study& study, const Stage& stage, double fraction,
                                         const Material& matrix, const PronySeries& composite) {
  if (stage.fillers.empty()) return std::nullopt;
  const auto& filler = stage.fillers.front().material;
  return ExpandingFiller{expansion_of(study, filler), fraction, filler.bulk, matrix.bulk, composite};
}

/// The expansion of the material that is the matrix of a stage, and how it is built from the binder on.
ThermalExpansion expansion_of_matrix(const Study& study, const Stage& stage, const std::vector<StageResult>& earlier,
                                     const TestId& test) {
  const auto* inner = stage_of_matrix(study, stage);
  if (inner == nullptr) return ThermalExpansion(expansion_of(study, std::get<Material>(stage.matrix)));
  auto expansion = expansion_of_matrix(study, *inner, earlier, test);
  const auto& matrix = matrix_of(inner->name, inner->matrix, earlier, test.boundary, test.method);
  const auto& composite = matrix_of(stage.name, stage.matrix, earlier, test.boundary, test.method);
  const auto& found = *std::ranges::find(earlier, inner->name, &StageResult::name);
  if (auto filler = filler_of(study, *inner, found.point_fraction, matrix, composite.bulk)) {
    expansion.add(*std::move(filler));
  }
  return expansion;
}

/// The error of the expansion of the matrix of a stage at a time of its curves; nothing where it is not known.
std::optional<double> error_of_matrix(const Study& study, const Stage& stage, const std::vector<StageResult>& earlier,
                                      const TestId& test, std::size_t time) {
  const auto* inner = stage_of_matrix(study, stage);
  if (inner == nullptr) return 0.0;
  const auto& found = *std::ranges::find(earlier, inner->name, &StageResult::name);
  for (const auto& [of, samples] : found.expansions) {
    if (of.boundary == test.boundary && of.method == test.method && time < samples.size()) return samples[time].error;
  }
  return std::nullopt;
}

}  // namespace

std::vector<StageExpansion> stage_expansions(const Study& study, const Stage& stage, const StageFindings& found,
                                             const std::vector<StageResult>& earlier) {
  if (!asks_for_expansion(study) || obstacle_to_expansion(study, stage)) return {};
  std::vector<StageExpansion> expansions;
  for (const auto& test : found.tests) {
    const bool is_preferred_one =
        find_preferred_test(found.tests, Load::bulk, test.id.boundary, test.id.method) == &test;
    if (!is_preferred_one || !(test.series.unrelaxed() > 0.0)) continue;
    auto expansion = expansion_of_matrix(study, stage, earlier, test.id);
    const auto& matrix = matrix_of(stage.name, stage.matrix, earlier, test.id.boundary, test.id.method);
    if (auto filler = filler_of(study, stage, found.point_fraction, matrix, test.series)) {
      expansion.add(*std::move(filler));
    }
    auto& samples = expansions.emplace_back(StageExpansion{test.id, {}}).samples;
    for (std::size_t i = 0; i < test.modulus.size(); ++i) {
      const double time = test.modulus[i].time;
      const auto of_bulk = i < test.errors.size() ? test.errors[i].whole() : std::nullopt;
      const auto of_matrix = error_of_matrix(study, stage, earlier, test.id, i);
      std::optional<double> error;
      if (of_bulk && of_matrix) error = std::hypot(expansion.sensitivity(time) * *of_bulk, *of_matrix);
      samples.push_back({time, expansion.at(time), error});
    }
  }
  return expansions;
}

void add_expansions(const Study& study, const Stage& stage, const std::vector<StageResult>& earlier,
                    StageFindings& found) {
  try {
    found.expansions = stage_expansions(study, stage, found, earlier);
  } catch (const InputError& error) {
    auto warning = fmt::format("{}: no thermal expansion: {}", stage.name, error.what());
    const bool is_known = std::ranges::find(found.warnings, warning) != found.warnings.end();
    if (!is_known) found.warnings.push_back(std::move(warning));
  }
}

}  // namespace breccia
