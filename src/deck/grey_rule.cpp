#include "deck/grey_rule.hpp"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "microstructure/image/grey_histogram.hpp"
#include "microstructure/image/image_sides.hpp"
#include "microstructure/image/median_filter.hpp"

namespace breccia {
namespace {

enum class ThresholdWord { otsu };

std::optional<double> read_threshold(const Section& packing) {
  const auto kind = packing.kind("threshold");
  if (kind == Kind::integer || kind == Kind::number) return packing.optional_number("threshold");
  if (kind == Kind::text) {
    static_cast<void>(packing.choice<ThresholdWord>("threshold", {{"otsu", ThresholdWord::otsu}}));
  } else {
    packing.report("threshold", "expected \"otsu\" or a grey value of the picture, such as 115");
  }
  return std::nullopt;
}

int read_median_side(const Section& packing) {
  constexpr Range sides = {.lower = 3.0, .upper = 15.0};
  const auto side = packing.optional_integer("smooth", sides).value_or(1);
  if (side % 2 == 1) return static_cast<int>(side);
  packing.report("smooth",
                 fmt::format("expected an odd number, the side of the square of pixels whose median each pixel "
                             "takes, got {}",
                             side));
  return 1;
}

/// Throws InputError if the values of a picture do not rise with the brightness.
void require_grey_values(const Raster& raster) {
  if (raster.shades == Shades::palette) {
    throw InputError(
        "the values of this picture are numbers of the colours of a palette; expected grey values: save it "
        "as a grey picture without a palette");
  }
  if (raster.shades == Shades::falling) {
    throw InputError("in this picture 0 is white (\"min is white\"); expected one in which 0 is black");
  }
}

/// Throws InputError if a threshold is one of a scale from 0 to 1, though the grey values are another.
void require_scale(double threshold, const GreyHistogram& histogram) {
  if (!(threshold > 0.0 && threshold < 1.0) || histogram.brightest() <= 1) return;
  throw InputError(fmt::format("expected a threshold on the scale of the grey values, here from {} to {}, got {}",
                               histogram.darkest(), histogram.brightest(), threshold));
}

}  // namespace

GreyRule read_grey_rule(const Section& packing) {
  return {.threshold = read_threshold(packing), .median_side = read_median_side(packing)};
}

GreyLabels grey_labels(const Raster& raster, const GreyRule& rule) {
  require_grey_values(raster);
  const auto& extents = raster.extents;
  std::vector<std::int32_t> smoothed;
  if (rule.median_side > 1) {
    smoothed =
        median_filtered(raster.values, {extents[0], extents[1], extents.size() > 2 ? extents[2] : 1}, rule.median_side);
  }
  const auto& values = smoothed.empty() ? raster.values : smoothed;
  const GreyHistogram histogram(values);
  if (rule.threshold) require_scale(*rule.threshold, histogram);
  auto made = histogram.divided_at(rule.threshold ? *rule.threshold : histogram.otsu_threshold());
  made.is_otsu = !rule.threshold;
  made.median_side = rule.median_side;
  made.dark.label = rule.dark;
  made.bright.label = rule.bright;
  // Lines of one value are no sign of a frame where a picture has few values.
  constexpr std::size_t several = 16;
  if (histogram.distinct_values() >= several) made.frame = frame_of(raster.values, extents);
  std::vector<Label> labels(values.size());
  std::ranges::transform(values, labels.begin(),
                         [&](std::int32_t value) { return value > made.threshold ? rule.bright : rule.dark; });
  return {made, std::move(labels)};
}

}  // namespace breccia
