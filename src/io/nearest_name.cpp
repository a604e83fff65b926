#include "io/nearest_name.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/lower_case.hpp"

namespace breccia {

namespace {

/// Damerau-Levenshtein distance in its restricted form (optimal string alignment).
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last(b.size() + 1);
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> current(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    current[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      current[j] = std::min({last[j] + 1, current[j - 1] + 1, replaced});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) current[j] = std::min(current[j], before_last[j - 2] + 1);
    }
    std::swap(before_last, last);
    std::swap(last, current);
  }
  return last[b.size()];
}

}  // namespace

std::optional<std::string> nearest_name(std::string_view mistyped, std::span<const std::string> known) {
  std::optional<std::string> nearest;
  std::size_t smallest = 0;
  for (const auto& candidate : known) {
    const auto distance = edit_distance(lower_case(std::string(mistyped)), lower_case(candidate));
    const auto tolerated = std::max<std::size_t>(1, std::max(candidate.size(), mistyped.size()) / 3);
    if (distance > tolerated || (nearest && distance >= smallest)) continue;
    nearest = candidate;
    smallest = distance;
  }
  return nearest;
}

std::string suggestion(std::string_view mistyped, std::span<const std::string> known) {
  if (const auto nearest = nearest_name(mistyped, known)) return fmt::format(", did you mean \"{}\"?", *nearest);
  if (known.empty()) return {};
  return fmt::format("; known: \"{}\"", fmt::join(known, "\", \""));
}

}  // namespace breccia
