#include "study/gap.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/display.hpp"
#include "io/units.hpp"
#include "study/filler_sizes.hpp"

namespace breccia {
namespace {

/// The form in which the deck gives the gap, as the end of a text; empty for a length.
std::string source_in_words(const Stage& stage, const Filler& filler) {
  if (filler.gap_source == GapSource::points) {
    return fmt::format(", from {:.6g} points", filler.gap / (0.5 * stage.cell_size()));
  }
  const auto diameters = diameters_of(filler);
  if (filler.gap_source == GapSource::length || !diameters) return {};
  return fmt::format(", {}{:.4g} % of the smallest diameter",
                     filler.gap_source == GapSource::default_share ? "the default of " : "",
                     100.0 * filler.gap / diameters->smallest);
}

}  // namespace

std::string gap_in_words(const Stage& stage, const Filler& filler) {
  const double gap = filler.gap;
  const auto cells = fmt::format("{:.3g}", gap / stage.cell_size());
  return fmt::format("{} ({} {} of {}{})", readable(gap, Dimension::length), cells, cells == "1" ? "cell" : "cells",
                     display(stage.cell_size(), "m", 3), source_in_words(stage, filler));
}

std::string gaps_in_words(const Stage& stage) {
  std::vector<std::string> gaps;
  for (const auto& filler : stage.fillers) {
    auto gap = gap_in_words(stage, filler);
    if (std::ranges::find(gaps, gap) == gaps.end()) gaps.push_back(std::move(gap));
  }
  return fmt::format("{}", fmt::join(gaps, " and "));
}

}  // namespace breccia
