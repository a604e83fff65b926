#include "report/colour_range.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "report/colour_map.hpp"

namespace breccia {
namespace {

/// The quantile of the values for a share, 0 to 1.
double percentile(std::vector<double> values, double share) {
  const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + place, values.end());
  return values[static_cast<std::size_t>(place)];
}

}  // namespace

ColourRange::ColourRange(ColourScale scale, const std::vector<double>& values) : scale_(scale) {
  constexpr double left_out = 0.01;
  std::vector<double> shown = values;
  if (is_logarithmic()) std::erase_if(shown, [](double value) { return value <= 0.0; });
  if (shown.empty()) shown = {1.0};
  from_ = percentile(shown, left_out);
  to_ = percentile(shown, 1.0 - left_out);
  // A uniform field gets the middle colour, without patterns from rounding.
  constexpr double least_span = 1e-6;
  if (to_ - from_ > least_span * std::max(std::abs(from_), std::abs(to_))) return;
  const double middle = 0.5 * (from_ + to_);
  from_ = middle == 0.0 ? -1.0 : std::min(0.5 * middle, 1.5 * middle);
  to_ = middle == 0.0 ? 1.0 : std::max(0.5 * middle, 1.5 * middle);
}

ColourRange ColourRange::diverging_if_signed(ColourScale scale, const std::vector<double>& values) {
  const ColourRange range(scale, values);
  constexpr double part = 0.02;
  const bool is_signed = std::min(-range.from_, range.to_) > part * (range.to_ - range.from_);
  return scale == ColourScale::linear && is_signed ? ColourRange(ColourScale::diverging, values) : range;
}

std::array<Rgb, 256> ColourRange::colours() const {
  return scale_ == ColourScale::diverging ? diverging_colours() : perceptual_colours();
}

double ColourRange::value_at(double share) const {
  return is_logarithmic() ? from_ * std::pow(to_ / from_, share) : std::lerp(from_, to_, share);
}

std::uint8_t ColourRange::index_of(double value) const {
  constexpr double last = 255.0;
  if (is_logarithmic() && value <= 0.0) return 0;
  if (scale_ == ColourScale::diverging) {
    const double share = 0.5 + 0.5 * std::clamp(value, from_, to_) / std::max(std::abs(from_), std::abs(to_));
    return static_cast<std::uint8_t>(std::lround(last * share));
  }
  const double share =
      is_logarithmic() ? std::log(value / from_) / std::log(to_ / from_) : (value - from_) / (to_ - from_);
  return static_cast<std::uint8_t>(std::lround(last * std::clamp(share, 0.0, 1.0)));
}

}  // namespace breccia
