#include "microstructure/image/grey_histogram.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia {

GreyHistogram::GreyHistogram(std::span<const std::int32_t> values) : pixels_(values.size()) {
  const auto [darkest, brightest] = std::ranges::minmax(values);
  constexpr std::int64_t most = 65536;
  const auto span = std::int64_t{brightest} - darkest + 1;
  if (span > most) {
    throw InputError(
        fmt::format("grey values from {} to {}; expected at most {} different ones, as in a picture of 16 "
                    "bits",
                    darkest, brightest, most));
  }
  darkest_ = darkest;
  counts_.resize(static_cast<std::size_t>(span));
  for (const auto value : values) ++counts_[static_cast<std::size_t>(value - darkest)];
}

std::int32_t GreyHistogram::brightest() const {
  return darkest_ + static_cast<std::int32_t>(counts_.size()) - 1;
}

std::size_t GreyHistogram::distinct_values() const {
  return static_cast<std::size_t>(std::ranges::count_if(counts_, [](std::size_t count) { return count > 0; }));
}

double GreyHistogram::otsu_threshold() const {
  if (counts_.size() == 1) throw InputError(fmt::format("all pixels have the grey value {}", darkest_));
  const auto all = static_cast<double>(pixels_);
  const double mean = side(darkest_, brightest()).mean;
  std::int32_t best = darkest_;
  double largest = -1.0;
  std::size_t pixels = 0;
  std::int64_t above_darkest = 0;  // sum of the values over the darkest one
  for (auto value = darkest_; value < brightest(); ++value) {
    const auto count = counts_[static_cast<std::size_t>(value - darkest_)];
    pixels += count;
    above_darkest += static_cast<std::int64_t>(count) * (value - darkest_);
    const double share = static_cast<double>(pixels) / all;
    const double moment = static_cast<double>(above_darkest) / all;
    const double deviation = (mean - darkest_) * share - moment;
    const double between = deviation * deviation / (share * (1.0 - share));
    if (between <= largest) continue;
    largest = between;
    best = value;
  }
  auto last = best;
  while (counts_[static_cast<std::size_t>(last + 1 - darkest_)] == 0) ++last;  // the brightest value has pixels
  return 0.5 * (best + last);
}

GreySegmentation GreyHistogram::divided_at(double threshold) const {
  if (threshold < darkest_ || threshold >= brightest()) {
    throw InputError(
        fmt::format("expected a threshold from {} to below {}, the darkest and the brightest grey value, "
                    "got {}",
                    darkest_, brightest(), threshold));
  }
  const auto last_dark = last_up_to(threshold);
  const auto all = side(darkest_, brightest());
  GreySegmentation made{
      .threshold = threshold, .dark = side(darkest_, last_dark), .bright = side(last_dark + 1, brightest())};
  double variance = 0.0;
  for (std::size_t number = 0; number < counts_.size(); ++number) {
    const double deviation = darkest_ + static_cast<double>(number) - all.mean;
    variance += static_cast<double>(counts_[number]) / static_cast<double>(pixels_) * deviation * deviation;
  }
  const double distance = made.bright.mean - made.dark.mean;
  made.separability = made.dark.share * made.bright.share * distance * distance / variance;
  made.margin = 0.1 * distance;
  made.bright_at_lower = share_above(threshold - made.margin);
  made.bright_at_higher = share_above(threshold + made.margin);
  return made;
}

GreySide GreyHistogram::side(std::int32_t first, std::int32_t last) const {
  GreySide made{.darkest = brightest(), .brightest = darkest_};
  std::size_t pixels = 0;
  std::int64_t above_darkest = 0;
  for (auto value = first; value <= last; ++value) {
    const auto count = counts_[static_cast<std::size_t>(value - darkest_)];
    if (count == 0) continue;
    made.darkest = std::min(made.darkest, value);
    made.brightest = std::max(made.brightest, value);
    pixels += count;
    above_darkest += static_cast<std::int64_t>(count) * (value - darkest_);
  }
  made.mean = darkest_ + static_cast<double>(above_darkest) / static_cast<double>(pixels);
  made.share = static_cast<double>(pixels) / static_cast<double>(pixels_);
  return made;
}

double GreyHistogram::share_above(double threshold) const {
  if (threshold < darkest_) return 1.0;
  if (threshold >= brightest()) return 0.0;
  return side(last_up_to(threshold) + 1, brightest()).share;
}

std::int32_t GreyHistogram::last_up_to(double threshold) const {
  return static_cast<std::int32_t>(std::floor(threshold));
}

}  // namespace breccia
