#include "homogenisation/run/stage_expansions.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "breccia/viscoelasticity/thermal_expansion.hpp"

#include "homogenisation/anisotropy.hpp"
#include "homogenisation/stage_materials.hpp"
#include "study/chain.hpp"
#include "study/expansion_rules.hpp"

namespace breccia {
namespace {

void add_once(std::vector<std::string>& warnings, std::string warning) {
  if (std::ranges::find(warnings, warning) == warnings.end()) warnings.push_back(std::move(warning));
}

/// Whether a box whose particles or pixels are given shows by its shears that it is not isotropic.
bool is_anisotropic(const Stage& stage, const StageFindings& found) {
  constexpr double most = 0.2;
  const auto anisotropy = anisotropy_of_tests(stage.dimensions(), found.tests);
  const bool is_given = stage.has_image() || stage.is_listed();
  return is_given && anisotropy && std::max(anisotropy->first.distance, anisotropy->last.distance) > most;
}

double expansion_of(const Study& study, const Material& material) {
  if (is_void(material)) return 0.0;
  return *find_material(study.materials, material.name)->thermal_expansion;
}

/// The expansion of a stage whose bulk modulus is given, from the binder on.
ThermalExpansion expansion_of(const Study& study, const Stage& stage, const PronySeries& bulk,
                              const std::vector<StageResult>& earlier, const TestId& test) {
  const auto& matrix = matrix_of(stage.name, stage.matrix, earlier, test.boundary, test.method);
  const auto* inner = stage_of_matrix(study, stage);
  auto expansion = inner == nullptr ? ThermalExpansion(expansion_of(study, matrix))
                                    : expansion_of(study, *inner, matrix.bulk, earlier, test);
  if (stage.fillers.empty()) return expansion;
  const auto& filler = stage.fillers.front().material;
  expansion.add({expansion_of(study, filler), filler.bulk, matrix.bulk, bulk});
  return expansion;
}

/// The expansion of an earlier stage under the boundary and by the method of a test; nullptr where it has none.
const StageExpansion* expansion_under(const TestId& test, const Stage& stage, const std::vector<StageResult>& results) {
  const auto& found = *std::ranges::find(results, stage.name, &StageResult::name);
  const auto known = std::ranges::find_if(found.expansions, [&test](const StageExpansion& one) {
    return one.test.boundary == test.boundary && one.test.method == test.method;
  });
  return known == found.expansions.end() ? nullptr : &*known;
}

/// The error of an expansion at a time; nothing where it is not known.
std::optional<double> error_at(const StageExpansion& expansion, double time) {
  constexpr double rounding = 1e-9;
  const auto sample = std::ranges::find_if(
      expansion.samples, [time](const ExpansionSample& one) { return std::abs(one.time / time - 1.0) < rounding; });
  return sample == expansion.samples.end() ? std::nullopt : sample->error;
}

/// The expansion by a test in bulk. `of_matrix` is that of the matrix where this is an earlier stage, or nullptr.
StageExpansion expansion_by(const TestResult& test, const ThermalExpansion& expansion,
                            const StageExpansion* of_matrix) {
  StageExpansion result{test.id, {}};
  for (std::size_t i = 0; i < test.modulus.size(); ++i) {
    const double time = test.modulus[i].time;
    const double sensitivity = expansion.sensitivity(time);
    std::optional<double> error = of_matrix == nullptr ? std::optional(0.0) : error_at(*of_matrix, time);
    if (sensitivity > 0.0) {
      const auto of_bulk = i < test.errors.size() ? test.errors[i].whole() : std::nullopt;
      error = error && of_bulk ? std::optional(std::hypot(sensitivity * *of_bulk, *error)) : std::nullopt;
    }
    result.samples.push_back({time, expansion.at(time), error});
  }
  return result;
}

}  // namespace

void add_expansions(const Study& study, const Stage& stage, const std::vector<StageResult>& earlier,
                    StageFindings& found) {
  found.expansions.clear();
  if (!asks_for_expansion(study) || obstacle_to_expansion(study, stage)) return;
  if (is_anisotropic(stage, found)) {
    add_once(found.warnings,
             fmt::format("{}: no thermal expansion: its shears are more than a fifth apart, so that it is "
                         "not isotropic",
                         stage.name));
    return;
  }
  const auto* inner = stage_of_matrix(study, stage);
  for (const auto& test : found.tests) {
    const auto* preferred = find_preferred_test(found.tests, Load::bulk, test.id.boundary, test.id.method);
    if (preferred != &test || !(test.series.unrelaxed() > 0.0)) continue;
    const auto* of_matrix = inner == nullptr ? nullptr : expansion_under(test.id, *inner, earlier);
    // The warning of the earlier stage says why.
    if (inner != nullptr && of_matrix == nullptr) continue;
    const auto& matrix = matrix_of(stage.name, stage.matrix, earlier, test.id.boundary, test.id.method);
    const auto obstacle =
        stage.fillers.empty() ? std::nullopt : obstacle_in_moduli(stage.fillers.front().material, matrix);
    if (obstacle) {
      add_once(found.warnings,
               fmt::format("{}, {}: no thermal expansion: {}", stage.name, name_of(test.id.boundary), *obstacle));
      continue;
    }
    const auto expansion = expansion_of(study, stage, test.series, earlier, test.id);
    found.expansions.push_back(expansion_by(test, expansion, of_matrix));
  }
}

}  // namespace breccia
