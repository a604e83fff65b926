#include "deck/gap.hpp"

#include <charconv>
#include <cmath>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "deck/rounding.hpp"
#include "io/percentage.hpp"
#include "study/filler_sizes.hpp"
#include "study/gap.hpp"

namespace breccia {
namespace {

/// A gap and the form in which the deck gives it.
struct Gap {
  double length;  ///< [m]
  GapSource source;
};

/// A number of material points such as "6 points".
std::optional<double> parse_points(const std::string& text) {
  double points = 0.0;
  const auto* const end_of_text = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), end_of_text, points);
  const std::string unit(end, end_of_text);
  const bool names_points = unit == " points" || unit == " point";
  const bool is_gap = error == std::errc{} && names_points && points >= 0.0 && std::isfinite(points);
  return is_gap ? std::optional(points) : std::nullopt;
}

/// A share of the smallest diameter such as "10 %".
std::optional<double> parse_share(const std::string& text) {
  constexpr double largest = 100.0;
  const auto share = parse_percentage(text);
  return share && *share >= 0.0 && *share <= largest ? share : std::nullopt;
}

std::optional<double> parse_length(const std::string& text) {
  try {
    const double length = parse_quantity(text, Dimension::length);
    return length >= 0.0 ? std::optional(length) : std::nullopt;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// The gap that a text stands for; nothing if the text is not a gap.
std::optional<Gap> parse_gap(const std::string& text, double point_spacing, double smallest_diameter) {
  if (const auto points = parse_points(text)) return Gap{*points * point_spacing, GapSource::points};
  if (const auto share = parse_share(text)) return Gap{*share * smallest_diameter, GapSource::diameter};
  if (const auto length = parse_length(text)) return Gap{*length, GapSource::length};
  return std::nullopt;
}

}  // namespace

void read_gap(const Section& section, const Stage& stage, Filler& filler) {
  if (stage.has_grains()) {
    section.refuse({"gap"}, "grains of a tessellation are parted by films: packing.film, or the fraction");
    return;
  }
  if (!stage.is_random()) {
    section.refuse({"gap"}, "only a random packing keeps a gap");
    return;
  }
  // Missing sizes have been reported as a mistake already.
  const auto diameters = diameters_of(filler);
  const double smallest = diameters && diameters->smallest > 0.0 ? diameters->smallest : 0.0;
  std::optional<Gap> gap;
  if (!section.has("gap")) {
    gap = Gap{default_gap_share * smallest, GapSource::default_share};
  } else if (section.is_distribution("gap")) {
    const double length = section.quantity("gap", Dimension::length, Range::not_negative());
    if (!std::isnan(length)) gap = Gap{length, GapSource::length};
  } else if (const auto text = section.optional_text("gap")) {
    gap = parse_gap(*text, stage.cell_size() / 2.0, smallest);
    if (!gap) {
      section.report("gap", fmt::format("expected a length such as \"0.5 um\", a share of the smallest diameter such "
                                        "as \"10 %\" or a number of material points such as \"6 points\", got \"{}\"",
                                        *text));
    }
  }
  if (!gap) return;
  if (gap->source == GapSource::points && stage.cells == 0) {
    section.report("gap",
                   "a number of material points is a length only where box and cells are given; expected a "
                   "length or a share of the smallest diameter");
    return;
  }
  // The gap is rounded, so that a length gives the same number in every form.
  filler.gap = as_typed(gap->length);
  filler.gap_source = gap->source;
}

}  // namespace breccia
