#include "breccia/report/field_picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/io/display.hpp"

#include "colour_map.hpp"
#include "embedded_png.hpp"
#include "markup.hpp"

namespace breccia {
namespace {

/// A square map of values.
struct Raster {
  std::size_t columns = 0;
  std::vector<double> values;
};

/// Means over equal squares, the smallest for which at most `most` columns remain; the last squares may be smaller.
Raster reduced(const FieldPicture& picture, std::size_t most) {
  const auto columns = picture.columns;
  const auto side = (columns + most - 1) / most;
  Raster raster = {(columns + side - 1) / side, {}};
  for (std::size_t row = 0; row < columns; row += side) {
    for (std::size_t column = 0; column < columns; column += side) {
      const auto last_row = std::min(row + side, columns), last_column = std::min(column + side, columns);
      double sum = 0.0;
      for (auto y = row; y < last_row; ++y) {
        for (auto x = column; x < last_column; ++x) sum += picture.values[y * columns + x];
      }
      raster.values.push_back(sum / static_cast<double>((last_row - row) * (last_column - column)));
    }
  }
  return raster;
}

/// The quantile of the values for a share, 0 to 1.
double percentile(std::vector<double> values, double share) {
  const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + place, values.end());
  return values[static_cast<std::size_t>(place)];
}

/// The range of values from the lowest to the highest colour.
class Colours {
 public:
  Colours(ColourScale scale, const std::vector<double>& values) : scale_(scale) {
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

  /// The value at a share of the scale, 0 to 1.
  [[nodiscard]] double value_at(double share) const {
    return is_logarithmic() ? from_ * std::pow(to_ / from_, share) : std::lerp(from_, to_, share);
  }
  [[nodiscard]] std::uint8_t index_of(double value) const {
    constexpr double last = 255.0;
    if (is_logarithmic() && value <= 0.0) return 0;
    const double share =
        is_logarithmic() ? std::log(value / from_) / std::log(to_ / from_) : (value - from_) / (to_ - from_);
    return static_cast<std::uint8_t>(std::lround(last * std::clamp(share, 0.0, 1.0)));
  }

 private:
  [[nodiscard]] bool is_logarithmic() const noexcept { return scale_ == ColourScale::logarithmic; }

  ColourScale scale_;
  double from_, to_;
};

/// The pixels row by row from the top, while the values begin at the bottom.
std::string encoded_map(const Raster& raster, const Colours& colours) {
  std::vector<std::uint8_t> pixels;
  pixels.reserve(raster.values.size());
  for (auto row = raster.values.size() / raster.columns; row-- > 0;) {
    for (std::size_t column = 0; column < raster.columns; ++column) {
      pixels.push_back(colours.index_of(raster.values[row * raster.columns + column]));
    }
  }
  return embedded_png(raster.columns, pixels, perceptual_colours());
}

std::string encoded_bar() {
  std::vector<std::uint8_t> pixels(256);
  for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = static_cast<std::uint8_t>(255 - i);
  return embedded_png(1, pixels, perceptual_colours());
}

void require_square(const FieldPicture& picture) {
  if (picture.columns == 0 || picture.values.size() != picture.columns * picture.columns) {
    throw InputError(fmt::format("picture of a field: {} values do not fill a square of {} columns",
                                 picture.values.size(), picture.columns));
  }
  if (!std::ranges::all_of(picture.values, [](double value) { return std::isfinite(value); })) {
    throw InputError("picture of a field: a value is not finite");
  }
}

}  // namespace

std::string field_picture(const FieldPicture& picture) {
  require_square(picture);
  constexpr std::size_t most_columns = 600;
  const auto raster = reduced(picture, most_columns);
  const Colours colours(picture.scale, raster.values);
  const auto written = [&](double value) { return three_digits(value / picture.unit_size); };
  const auto [lowest, highest] = std::ranges::minmax(raster.values);

  std::string svg;
  const auto out = std::back_inserter(svg);
  // The map is drawn 1000 units wide, its bar to the right of it.
  fmt::format_to(
      out,
      R"svg(<svg xmlns="http://www.w3.org/2000/svg" viewBox="-20 -70 1240 1150" font-family="sans-serif" role="img" aria-labelledby="title">
<title id="title">{0}</title>
<rect x="-20" y="-70" width="1240" height="1150" fill="#fff"/>
<text y="-24" font-size="34" fill="#222">{0}</text>
<image width="1000" height="1000" preserveAspectRatio="none" style="image-rendering: pixelated" href="{1}"/>
<rect width="1000" height="1000" fill="none" stroke="#222" stroke-width="2"/>
<image x="1030" width="40" height="1000" preserveAspectRatio="none" href="{2}"/>
<rect x="1030" width="40" height="1000" fill="none" stroke="#222" stroke-width="2"/>
)svg",
      as_markup(picture.title), encoded_map(raster, colours), encoded_bar());
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const double y = 1000.0 * (1.0 - share);
    fmt::format_to(out, R"svg(<path d="M1070 {0}h10" stroke="#222" stroke-width="2"/>
<text x="1086" y="{1}" font-size="30" fill="#222">{2}</text>
)svg",
                   y, y + 11.0, written(colours.value_at(share)));
  }
  fmt::format_to(out, R"svg(<text y="1046" font-size="30" fill="#222">{}; it goes from {} to {}</text>
</svg>
)svg",
                 as_markup(picture.quantity), written(lowest), written(highest));
  return svg;
}

}  // namespace breccia
