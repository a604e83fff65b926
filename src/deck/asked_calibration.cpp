#include "deck/asked_calibration.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>

#include "deck/unknowns.hpp"
#include "io/collected_mistakes.hpp"

namespace breccia {
namespace {

/// The largest known error of the shear modulus of a stage over the times of its curves [-], with the distance of its
/// finest grid, on which predictions are made, from the limit of several grids; nothing where no error is known.
std::optional<double> error_of(const ObservedComposite& composite, const StageResponses& stage) {
  const auto results = composite.responder.respond();
  const auto result = std::ranges::find(results, composite.stage, &StageResult::name);
  const auto* const best = find_preferred_test(result->tests, stage.shear, composite.boundary);
  const auto error = best == nullptr ? std::nullopt : largest_whole(best->errors);
  if (!error) return error;
  double distance = 0.0;
  for (const auto& test : result->tests) {
    if (test.id.load != best->id.load || test.id.boundary != best->id.boundary) continue;
    if (test.id.grid.cells() != result->cells) continue;
    for (std::size_t i = 0; i < std::min(test.modulus.size(), best->modulus.size()); ++i) {
      distance = std::max(distance, std::abs(test.modulus[i].modulus / best->modulus[i].modulus - 1.0));
    }
  }
  return *error + distance;
}

/// The boundary whose moduli are taken for those of a composite: the periodic one, or else the first.
Boundary boundary_of(const StageResponses& responses) {
  const auto is_periodic = [](const StageResponses::Entry& entry) {
    return entry.response.boundary == Boundary::periodic;
  };
  return std::ranges::any_of(responses.entries, is_periodic) ? Boundary::periodic
                                                             : responses.entries.front().response.boundary;
}

ObservedComposite composite_of(const std::string& name, const Responder& responder, const AskedCalibration& asked) {
  const auto stage = asked.stage.empty() ? responder.stages().back().stage : asked.stage;
  const auto chain = responder.chain_of(stage);
  const auto& responses = *std::ranges::find(chain.stages(), stage, &StageResponses::stage);
  ObservedComposite composite = {.name = name, .responder = chain, .stage = stage, .boundary = boundary_of(responses)};
  const auto error = asked.model_error ? asked.model_error : error_of(composite, responses);
  composite.model_deviation = 0.5 * error.value_or(0.0);
  return composite;
}

/// The materials of all composites, each once.
std::vector<ShiftedMaterial> materials_of(const std::vector<ObservedComposite>& composites) {
  std::vector<ShiftedMaterial> materials;
  for (const auto& composite : composites) {
    for (const auto& one : composite.responder.materials()) {
      if (find_material(materials, one.material.name) == nullptr) materials.push_back(one);
    }
  }
  return materials;
}

}  // namespace

FoundCalibration calibrate(const AskedCalibration& asked) {
  FoundCalibration found;
  found.noise = asked.measured.noise ? Noise::known : Noise::relative;
  CollectedMistakes mistakes;
  for (const auto& one : asked.composites) {
    mistakes.collect([&] { found.composites.push_back(composite_of(one.first, one.second, asked)); });
  }
  found.observations = read_observations(asked.measured, found.notes, mistakes);
  std::vector<Unknown> unknowns;
  for (const auto& text : asked.unknowns) {
    mistakes.collect(
        [&] { unknowns.push_back(read_unknown(text, materials_of(found.composites), found.observations, "unknown")); });
  }
  mistakes.refuse();
  for (const auto& composite : found.composites) {
    if (composite.boundary == Boundary::periodic) continue;
    found.notes.push_back(fmt::format("{}: its box was tested under {} alone, and its apparent moduli are taken",
                                      composite.name, name_of(composite.boundary)));
  }
  found.result = calibrate(found.composites, unknowns, found.observations, {found.noise, asked.samples});
  return found;
}

}  // namespace breccia
