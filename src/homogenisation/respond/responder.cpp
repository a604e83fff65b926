#include "breccia/homogenisation/responder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "discretisation/contrast.hpp"
#include "homogenisation/material_warnings.hpp"
#include "homogenisation/plan/grid_error.hpp"
#include "homogenisation/quality.hpp"
#include "homogenisation/respond/coverage_refusal.hpp"
#include "homogenisation/respond/elastic_chain.hpp"
#include "homogenisation/respond/replaced_materials.hpp"
#include "homogenisation/respond/responded_stages.hpp"
#include "io/nearest_name.hpp"

namespace breccia {
namespace {

void require_one_study(const std::vector<StageResponses>& stages) {
  for (const auto& one : stages) {
    if (one.deck_hash == stages.front().deck_hash) continue;
    throw InputError(fmt::format(
        "the responses of stages {} and {} are of different studies (deck hashes {} and {}); run the study anew in a "
        "directory of its own",
        stages.front().stage, one.stage, stages.front().deck_hash, one.deck_hash));
  }
}

void require_different_stages(const std::vector<StageResponses>& stages) {
  for (auto one = stages.begin(); one != stages.end(); ++one) {
    if (std::ranges::find(stages.begin(), one, one->stage, &StageResponses::stage) == one) continue;
    throw InputError(
        fmt::format("the responses of stage {} are given twice; give those of each stage once", one->stage));
  }
}

/// The stage whose result is the matrix of a stage; nullptr if its matrix is a material, or that stage is missing.
const StageResponses* stage_of_matrix(const std::vector<StageResponses>& stages, const StageResponses& stage) {
  const auto* const earlier = std::get_if<EarlierStage>(&stage.matrix);
  if (earlier == nullptr) return nullptr;
  const auto found = std::ranges::find(stages, earlier->name, &StageResponses::stage);
  return found == stages.end() ? nullptr : &*found;
}

/// Throws InputError if stages build on each other in a circle, as files from other sources may declare.
void require_an_end(const std::vector<StageResponses>& stages) {
  for (const auto& one : stages) {
    std::size_t links = 0;
    for (const auto* stage = &one; stage != nullptr; stage = stage_of_matrix(stages, *stage)) {
      if (links++ < stages.size()) continue;
      throw InputError(fmt::format("the responses of stage {} build on themselves", one.stage));
    }
  }
}

/// The varying materials of a stage: its matrix, unless that is an earlier stage, and the materials of other phases
/// that vary. `Stage` is StageResponses, constant or not.
template <class Stage>
auto varying_materials(Stage& stage) {
  using Solid = std::conditional_t<std::is_const_v<Stage>, const Material, Material>;
  std::vector<Solid*> materials;
  if (auto* const matrix = std::get_if<Material>(&stage.matrix)) materials.push_back(matrix);
  for (auto& [phase, material] : stage.other_phases) materials.push_back(&material);
  return materials;
}

/// Whether more than the name of a material is known.
bool has_moduli(const Material& material) {
  return material.bulk.unrelaxed() > 0.0 && material.shear.unrelaxed() > 0.0;
}

void add_once(std::vector<std::string>& warnings, const std::string& warning) {
  if (std::ranges::find(warnings, warning) == warnings.end()) warnings.push_back(warning);
}

/// The binder of a stage: its matrix, or the matrix of the earlier stages that it builds on; nullptr where the binder
/// is unknown.
const Material* binder_of(const std::vector<StageResponses>& stages, const StageResponses& stage) {
  const auto* lowest = &stage;
  while (const auto* const below = stage_of_matrix(stages, *lowest)) lowest = below;
  const auto* const binder = std::get_if<Material>(&lowest->matrix);
  return binder != nullptr && has_moduli(*binder) ? binder : nullptr;
}

/// The warnings about a stage that depend on the varying materials: about these materials, and about fillers that are
/// softer than their binder.
std::vector<std::string> warnings_on_varying(const std::vector<StageResponses>& stages, const StageResponses& stage,
                                             const std::vector<ShiftedMaterial>& materials) {
  std::vector<std::string> warnings;
  for (const auto* const material : varying_materials(stage)) {
    if (!has_moduli(*material)) continue;
    if (auto warning = warning_of_poisson_ratio(*material, stage.times, stage.abscissa))
      warnings.push_back(*std::move(warning));
  }
  if (const auto* const matrix = std::get_if<Material>(&stage.matrix)) {
    for (const auto& warning : warnings_of_unknown_times(*matrix, stage.times, stage.abscissa)) {
      warnings.push_back(fmt::format("{}: {}", stage.stage, warning));
    }
  }
  if (const auto* const binder = binder_of(stages, stage)) {
    for (const auto& name : stage.fillers) {
      const auto* const filler = find_material(materials, name);
      if (filler == nullptr) continue;
      const auto warning = warning_of_soft_filler(filler->material, *binder, stage.times.begin, stage.abscissa);
      if (warning) add_once(warnings, fmt::format("{}: {}", stage.stage, *warning));
    }
  }
  return warnings;
}

/// Whether all fillers of a stage are stiffer than its present binder.
bool are_fillers_stiffer(const std::vector<StageResponses>& all, const std::vector<ShiftedMaterial>& materials,
                         const StageResponses& stage) {
  const auto* const binder = binder_of(all, stage);
  return binder != nullptr && std::ranges::all_of(stage.fillers, [&](const std::string& name) {
           const auto* const filler = find_material(materials, name);
           return filler != nullptr && are_stiffer_than_matrix(std::array{*binder, filler->material});
         });
}

/// The factor of the rule for the error of a single grid that the present binder of a stage makes (theory, Eq. 43g);
/// nothing where the rule does not hold, and for films and coatings, whose rules ask for more than the binder.
std::optional<double> factor_of_grid_rule(const std::vector<StageResponses>& all,
                                          const std::vector<ShiftedMaterial>& materials, const StageResponses& stage) {
  const bool is_of_films = std::ranges::any_of(stage.entries, [](const auto& entry) { return entry.grid.is_films(); });
  if (is_of_films || !stage.other_phases.empty() || !are_fillers_stiffer(all, materials, stage)) return std::nullopt;
  const double fall = steepest_fall(binder_of(all, stage)->shear, stage.times);
  return fall <= steepest_fall_with_rule ? std::optional(std::max(1.0, fall)) : std::nullopt;
}

/// Gives a stage the rules for its errors that hold with the present materials, from those of a slow binder.
void fit_rules(const std::vector<StageResponses>& all, const std::vector<ShiftedMaterial>& materials,
               StageResponses& stage) {
  const auto factor = factor_of_grid_rule(all, materials, stage);
  if (stage.rules.one_grid)
    stage.rules.one_grid = factor ? std::optional(*stage.rules.one_grid * *factor) : std::nullopt;
  if (!are_fillers_stiffer(all, materials, stage) && stage.rules.sample != SampleKind::whole) {
    stage.rules.sample = SampleKind::unknown;
  }
}

/// A temperature in degrees Celsius, rounded to a millionth of a degree: "40 degC".
std::string in_celsius(double kelvin) {
  constexpr double zero_celsius = 273.15, smallest = 1e-6;
  return fmt::format("{:.6g} degC", std::round((kelvin - zero_celsius) / smallest) * smallest);
}

}  // namespace

Responder::Responder(std::vector<StageResponses> stages, std::vector<ShiftedMaterial> materials)
    : stages_(std::move(stages)), materials_(std::move(materials)) {
  require_different_stages(stages_);
  require_one_study(stages_);
  require_an_end(stages_);
  for (auto& stage : stages_) {
    for (auto* const material : varying_materials(stage)) {
      const auto* const known = find_material(materials_, material->name);
      if (known == nullptr) {
        if (has_moduli(*material)) materials_.push_back({*material});
      } else if (!has_moduli(*material)) {
        *material = known->material;
      }
    }
  }
  // The rule for a single grid is kept for a slow binder, from which fit_rules() takes it to another one.
  for (auto& stage : stages_) {
    const auto factor = factor_of_grid_rule(stages_, materials_, stage);
    if (!factor) stage.rules.one_grid.reset();
    if (stage.rules.one_grid) *stage.rules.one_grid /= *factor;
  }
  // These warnings are made anew for the materials and the times of each response.
  for (auto& stage : stages_) {
    for (const auto& warning : warnings_on_varying(stages_, stage, materials_)) std::erase(stage.warnings, warning);
    // Results of earlier versions word it in this way.
    const auto of_times = fmt::format("{}: times reach from ", stage.stage);
    std::erase_if(stage.warnings, [&](const std::string& warning) { return warning.starts_with(of_times); });
  }
}

Responder Responder::at(double temperature) const {
  auto moved = *this;
  for (const auto& name : varying_materials(stages_)) {
    const auto* const known = find_material(materials_, name);
    if (known == nullptr) throw InputError(fmt::format("the study has no material \"{}\"", name));
    auto material = at_temperature(*known, temperature);
    const bool is_unshifted = is_elastic(material.material);
    const auto shown = shown_.find(name);
    const auto& own_name = shown == shown_.end() ? name : shown->second.material;
    moved.replace(name, std::move(material), {own_name, fmt::format(" at {}", in_celsius(temperature))});
    if (is_unshifted) moved.unshifted_.insert(name);
  }
  // The measurements are those at the temperature of the study.
  for (auto& stage : moved.stages_) stage.measurements.clear();
  return moved;
}

Responder Responder::with(const std::vector<NewMaterial>& materials) const {
  const auto replaced = replaced_materials(materials, stages_, materials_);
  auto changed = *this;
  for (std::size_t i = 0; i < materials.size(); ++i) {
    const auto& [name, material, shift] = materials[i];
    changed.replace(replaced[i], {material, shift}, {material.name});
  }
  return changed;
}

Responder Responder::within(const TimeWindow& times) const {
  auto changed = *this;
  for (auto& stage : changed.stages_) stage.times = times;
  return changed;
}

Responder Responder::over(Abscissa abscissa) const {
  auto changed = *this;
  for (auto& stage : changed.stages_) stage.abscissa = abscissa;
  return changed;
}

Responder Responder::chain_of(const std::string& stage) const {
  auto chain = *this;
  chain.stages_ = {stage_named(stage)};
  while (const auto* const below = stage_of_matrix(stages_, chain.stages_.back())) chain.stages_.push_back(*below);
  return chain;
}

Responder Responder::alone(const std::string& stage) const {
  auto changed = *this;
  auto one = stage_named(stage);
  if (std::holds_alternative<EarlierStage>(one.matrix)) one.matrix = Material{name_of(one.matrix), 0.0, {}, {}};
  changed.stages_ = {std::move(one)};
  return changed;
}

std::vector<StageResult> Responder::respond() const {
  if (stages_.empty()) return {};
  require_earlier_stages(stages_);
  auto stages = stages_with_shown_names();
  for (auto& stage : stages) fit_rules(stages_, materials_, stage);
  for (const auto& stage : stages) {
    const auto* const matrix = std::get_if<Material>(&stage.matrix);
    if (matrix == nullptr || has_moduli(*matrix)) continue;
    throw InputError(fmt::format("no new material for \"{}\", which is the matrix of a stage", matrix->name));
  }
  auto results = or_refuse_with_covered_times(stages.front().times, stages.front().abscissa,
                                              [&](const TimeWindow& times) { return responded_stages(stages, times); });
  add_warnings(results);
  return results;
}

ModulusAndGradient Responder::modulus_and_gradient(const std::string& stage, TestLoad load, Boundary boundary,
                                                   std::complex<double> laplace_variable) const {
  std::map<std::string, ComplexModuli> moduli;
  for (const auto& [material, shift, constants, expansion] : materials_)
    moduli[material.name] = carson_moduli(material, laplace_variable);
  return modulus_and_gradient(stage, load, boundary, moduli);
}

ModulusAndGradient Responder::modulus_and_gradient(const std::string& stage, TestLoad load, Boundary boundary,
                                                   const std::map<std::string, ComplexModuli>& moduli) const {
  return ElasticChain(stages_, moduli, boundary).modulus(stage, load);
}

std::vector<std::string> Responder::shown_names() const {
  const auto varying = varying_materials(stages_);
  std::vector<std::string> names;
  for (const auto& name : std::set<std::string>(varying.begin(), varying.end())) {
    const auto shown = shown_.find(name);
    names.push_back(shown == shown_.end() ? name : shown->second.text());
  }
  return names;
}

void Responder::replace(const std::string& name, ShiftedMaterial material, ShownName shown) {
  material.material.name = name;
  for (auto& stage : stages_) {
    for (auto* const one : varying_materials(stage)) {
      if (one->name == name) *one = material.material;
    }
  }
  const auto known = std::ranges::find_if(materials_, [&name](const auto& one) { return one.material.name == name; });
  if (known == materials_.end()) {
    materials_.push_back(std::move(material));
  } else {
    *known = std::move(material);
  }
  shown_[name] = std::move(shown);
  unshifted_.erase(name);
}

const StageResponses& Responder::stage_named(const std::string& stage) const {
  const auto found = std::ranges::find(stages_, stage, &StageResponses::stage);
  if (found != stages_.end()) return *found;
  std::vector<std::string> names;
  for (const auto& one : stages_) names.push_back(one.stage);
  throw InputError(fmt::format("no response of a stage \"{}\"{}", stage, suggestion(stage, names)));
}

std::vector<StageResponses> Responder::stages_with_shown_names() const {
  auto stages = stages_;
  for (auto& stage : stages) {
    for (auto* const material : varying_materials(stage)) {
      const auto shown = shown_.find(material->name);
      if (shown != shown_.end()) material->name = shown->second.text();
    }
  }
  return stages;
}

void Responder::add_warnings(std::vector<StageResult>& results) const {
  // Materials and warnings that a stage has named already; only the first stage names each of them.
  std::set<std::string> named, said;
  const auto stages = stages_with_shown_names();
  for (auto& result : results) {
    const auto& of_study = stage_named(result.name);
    result.warnings = of_study.warnings;
    auto answered = of_study;
    fit_rules(stages_, materials_, answered);
    result.accuracy = accuracy_of_answer(result, answered.rules);
    if (const auto* const matrix = std::get_if<Material>(&of_study.matrix)) {
      if (unshifted_.contains(matrix->name) && named.insert(matrix->name).second) {
        result.warnings.push_back(
            fmt::format("{} is elastic: its moduli do not depend on the temperature here, so they are those of the run",
                        matrix->name));
      }
    }
    const auto shown = std::ranges::find(stages, result.name, &StageResponses::stage);
    for (const auto& warning : warnings_on_varying(stages, *shown, materials_)) {
      if (said.insert(warning).second) add_once(result.warnings, warning);
    }
    StageQuality quality;
    quality.abscissa = of_study.abscissa;
    quality.loads = bounds_of_tests(result);
    for (const auto& warning : warnings_on_bounds(quality)) {
      result.warnings.push_back(fmt::format("{}: {}", result.name, warning));
    }
  }
}

Responder responder_of(const Study& study, const StudyResult& result) {
  return Responder(responses_of(study, result), study.materials);
}

}  // namespace breccia
