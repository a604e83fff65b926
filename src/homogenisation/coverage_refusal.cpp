#include "coverage_refusal.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/io/display.hpp"
#include "breccia/quasistatic/sampled_moduli.hpp"

namespace breccia {
namespace {

std::string seconds(double time) {
  return display(time, "s", 3);
}

std::string pascals(double modulus) {
  return display(modulus, "Pa", 3);
}

/// Rounds those ends of a window that lie within another one, inwards; nothing if no time is left.
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
std::string remedy_for(const StoredResponses& stored) {
  if (stored.range == SampledRange::times) {
    return "the study was run with tests.quasistatic.range = \"times\"; with \"matrix\", the default, it covers its "
           "own matrix at every temperature";
  }
  return "a new study with this material as its matrix covers all of it";
}

std::string describe(const char* modulus, const Material& matrix, const TimeWindow& window, const ModuliRange& shown,
                     const ModuliRange& sampled, double Moduli::*of) {
  return fmt::format("from {} to {} {} shows a {} modulus from {} to {}; the study has sampled {} to {}",
                     seconds(window.begin), seconds(window.end), matrix.name, modulus, pascals(shown.least.*of),
                     pascals(shown.most.*of), pascals(sampled.least.*of), pascals(sampled.most.*of));
}

}  // namespace

void require_coverage(const StoredResponses& stored, const MatrixUnder& matrix, const TimeWindow& window) {
  std::vector<std::string> lines;
  std::optional<TimeWindow> covered = window;
  for (const auto& [cells, response] : stored.entries) {
    const auto& material = matrix(response.boundary);
    const auto found = coverage(response, material, window);
    if (found.is_whole()) continue;
    covered = common(covered, found.times);
    const auto name = found.is_shear_covered ? "bulk" : "shear";
    const auto of = found.is_shear_covered ? &Moduli::bulk : &Moduli::shear;
    auto line =
        fmt::format("stage {}: {}", stored.stage, describe(name, material, window, found.shown, found.sampled, of));
    if (std::ranges::find(lines, line) == lines.end()) lines.push_back(std::move(line));
  }
  if (lines.empty()) return;
  if (covered) covered = rounded_within(*covered, window);
  throw NotCovered(fmt::format("{}\n{}", fmt::join(lines, "\n"), remedy_for(stored)), covered);
}

NotCovered with_covered_times(const NotCovered& refusal, const std::optional<TimeWindow>& times) {
  if (!times) return {refusal.what(), times};
  return {fmt::format("{}\ncovered from {} to {}", refusal.what(), seconds(times->begin), seconds(times->end)), times};
}

}  // namespace breccia
