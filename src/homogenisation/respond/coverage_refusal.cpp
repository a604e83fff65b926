#include "homogenisation/respond/coverage_refusal.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/display.hpp"
#include "quasistatic/reduced/sampled_moduli.hpp"
#include "study/abscissa_words.hpp"

namespace breccia {
namespace {

/// A window in seconds, "from 1 ms to 1 s", or in hertz.
std::string window_of(Abscissa abscissa, const TimeWindow& times) {
  if (abscissa == Abscissa::frequency) {
    const auto [begin, end] = hertz_within(times);
    return fmt::format("from {} to {}", display(begin, "Hz"), display(end, "Hz"));
  }
  return fmt::format("from {} to {}", display(times.begin, "s"), display(times.end, "s"));
}

std::string in_pascals(double modulus) {
  return display(modulus, "Pa", 3);
}

/// Rounds inwards those ends of a window that lie within another window; nothing if no time is left.
std::optional<TimeWindow> rounded_within(const TimeWindow& part, const TimeWindow& window) {
  const TimeWindow rounded = {part.begin > window.begin ? rounded_up_to_two_digits(part.begin) : window.begin,
                              part.end < window.end ? rounded_down_to_two_digits(part.end) : window.end};
  if (!(rounded.begin < rounded.end)) return std::nullopt;
  return rounded;
}

/// The intersection of two windows.
std::optional<TimeWindow> common(const std::optional<TimeWindow>& one, const std::optional<TimeWindow>& other) {
  if (!one || !other) return std::nullopt;
  const TimeWindow both = {std::max(one->begin, other->begin), std::min(one->end, other->end)};
  if (!(both.begin < both.end)) return std::nullopt;
  return both;
}

/// Advice on how to cover more times.
std::string remedy_for(const StageResponses& stage) {
  if (!stage.other_phases.empty()) {
    const auto is_elastic = [](const auto& phase) {
      return phase.second.bulk.is_elastic() && phase.second.shear.is_elastic();
    };
    return fmt::format("a new study with these materials covers all of them{}",
                       std::ranges::any_of(stage.other_phases, is_elastic)
                           ? "; moduli of elastic materials between two ends are sampled with tests.quasistatic.vary"
                           : "");
  }
  if (stage.range == SampledRange::times) {
    return "the study was run with tests.quasistatic.range = \"times\"; with \"matrix\", the default, it covers its "
           "own matrix at every temperature";
  }
  return "a new study with this material as its matrix covers all of it";
}

/// A description of the modulus of a phase that is not covered: the shear modulus or, where that is covered, the bulk
/// modulus.
std::string describe(const PhaseCoverage& found, const Material& material, const std::string& window) {
  const auto* name = found.is_shear_covered ? "bulk" : "shear";
  const auto of = found.is_shear_covered ? &Moduli::bulk : &Moduli::shear;
  const auto least = in_pascals(found.shown.least.*of), most = in_pascals(found.shown.most.*of);
  return fmt::format("{} {} shows a {} modulus {}; the responses hold from {} to {}", window, material.name, name,
                     least == most ? "of " + least : fmt::format("from {} to {}", least, most),
                     in_pascals(found.sampled.least.*of), in_pascals(found.sampled.most.*of));
}

}  // namespace

std::vector<Material> materials_for(const StageResponses& stage, const ReducedResponse& response,
                                    const Material& matrix) {
  auto by_phase = stage.other_phases;
  by_phase.insert_or_assign(std::string(name_of_matrix_phase), matrix);
  return response.materials(by_phase);
}

namespace {

/// Materials that are covered one by one may still lie beside the joint path of several phases: the error
/// estimate shows it.
void require_joint_coverage(const StageResponses& stage, const MatrixUnder& matrix, const TimeWindow& window) {
  constexpr double most = 0.01;
  double largest = 0.0;
  for (const auto& [grid, response] : stage.entries) {
    if (response.phases().size() < 2) continue;
    largest =
        std::max(largest, largest_error(response, materials_for(stage, response, matrix(response.boundary)), window));
  }
  if (largest <= most) return;
  throw NotCovered(
      fmt::format("stage {}: with these materials together the error of the reduced basis is about {:.2g} %, "
                  "expected {:.2g} % at most: the study has sampled the moduli of its phases along one path\n{}",
                  stage.stage, 100.0 * largest, 100.0 * most, remedy_for(stage)),
      std::nullopt);
}

}  // namespace

void require_coverage(const StageResponses& stage, const MatrixUnder& matrix, const TimeWindow& window) {
  std::vector<std::string> lines;
  std::optional<TimeWindow> covered = window;
  for (const auto& [grid, response] : stage.entries) {
    const auto materials = materials_for(stage, response, matrix(response.boundary));
    const auto found = coverage(response, materials, window);
    if (found.is_whole()) continue;
    covered = common(covered, found.times);
    for (std::size_t i = 0; i < materials.size(); ++i) {
      if (found.phases[i].is_whole()) continue;
      auto line = fmt::format("stage {}: {}", stage.stage,
                              describe(found.phases[i], materials[i], window_of(stage.abscissa, window)));
      if (std::ranges::find(lines, line) == lines.end()) lines.push_back(std::move(line));
    }
  }
  if (lines.empty()) {
    require_joint_coverage(stage, matrix, window);
    return;
  }
  if (covered) covered = rounded_within(*covered, window);
  throw NotCovered(fmt::format("{}\n{}", fmt::join(lines, "\n"), remedy_for(stage)), covered);
}

NotCovered with_covered_times(const NotCovered& refusal, const std::optional<TimeWindow>& times, Abscissa abscissa) {
  if (!times) return {refusal.what(), times};
  return {fmt::format("{}\ncovered {}", refusal.what(), window_of(abscissa, *times)), times, abscissa};
}

}  // namespace breccia
