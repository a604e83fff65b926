#include "cli/compared_tables.hpp"

#include <algorithm>
#include <cstddef>
#include <numbers>

#include <fmt/format.h>

#include "io/display.hpp"
#include "results/curve_places.hpp"

namespace breccia::cli {
namespace {

std::string value_in_words(const ComparedCurve& curve, double value) {
  if (curve.curve != ObservedCurve::phase) return display(value, "Pa");
  return fmt::format("{:.3g} deg", value * 180.0 / std::numbers::pi);
}

/// How a result differs from the first: "1.08 +- 0.03", "1.01 +- 0.03 (=)" where the errors explain it, "+2 deg".
std::string difference_in_words(const ComparedCurve& curve, const CurveDifference& difference) {
  const auto& [value, error] = difference;
  if (curve.curve == ObservedCurve::phase) return fmt::format("{:+.2g} deg", value * 180.0 / std::numbers::pi);
  if (!error) return fmt::format("{:#.4g}", value);
  const auto ratio = fmt::format("{:#.4g} +- {:.2g}", value, value * *error);
  return difference.is_beyond_error() ? ratio : fmt::format("{} {}", ratio, within_errors);
}

}  // namespace

std::string letter_of(std::size_t result) {
  return {static_cast<char>('A' + static_cast<char>(result))};
}

std::string table_of_decks(const std::vector<DeckDifference>& differences) {
  std::size_t width = 0;
  std::vector<std::size_t> widths;
  for (const auto& [path, texts] : differences) {
    width = std::max(width, path.size());
    widths.resize(texts.size(), 1);
    for (std::size_t i = 0; i < texts.size(); ++i) widths[i] = std::max(widths[i], texts[i].size());
  }
  std::string text;
  for (const auto& [path, texts] : differences) {
    text += fmt::format("  {:<{}}", path, width);
    for (std::size_t i = 0; i < texts.size(); ++i) {
      text += fmt::format("  {:<{}}", texts[i].empty() ? "-" : texts[i], widths[i]);
    }
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
  }
  return text;
}

bool lacks_errors(const ComparedCurve& curve) {
  if (curve.curve == ObservedCurve::phase) return false;
  for (std::size_t result = 1; result < curve.errors.size(); ++result) {
    for (std::size_t i = 0; i < curve.at.size(); ++i) {
      if (!difference_from_first(curve, result, i).error) return true;
    }
  }
  return false;
}

std::string table_of_compared(const ComparedCurve& curve) {
  const auto abscissa = is_over_frequency(curve.curve) ? Abscissa::frequency : Abscissa::time;
  const auto results = curve.errors.size();
  const auto sign = curve.curve == ObservedCurve::phase ? " - " : "/";
  auto text = fmt::format("{}\n{:>10}", curve.name, abscissa == Abscissa::time ? "time" : "frequency");
  for (std::size_t result = 0; result < results; ++result) text += fmt::format("  {:>10}", letter_of(result));
  for (std::size_t result = 1; result < results; ++result) {
    text += fmt::format("  {:>20}", letter_of(result) + sign + letter_of(0));
  }
  text += '\n';
  for (const auto i : decades_of(curve.at, abscissa)) {
    text += fmt::format("{:>10}", place_in_words(curve.at[i], abscissa));
    for (std::size_t result = 0; result < results; ++result) {
      const double value = curve.values(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(result));
      text += fmt::format("  {:>10}", value_in_words(curve, value));
    }
    for (std::size_t result = 1; result < results; ++result) {
      text += fmt::format("  {:>20}", difference_in_words(curve, difference_from_first(curve, result, i)));
    }
    text += '\n';
  }
  return text;
}

}  // namespace breccia::cli
