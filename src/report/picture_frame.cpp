#include "report/picture_frame.hpp"

#include <cmath>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "io/display.hpp"

namespace breccia {
namespace {

/// The strip for the scale bar is below the box.
constexpr double margin = 20.0;
constexpr double strip = 70.0;

}  // namespace

double scale_bar_length(double side) {
  const double longest = side / 4.0;
  const double power = std::pow(10.0, std::floor(std::log10(longest) + 1e-9));
  for (const double step : {5.0, 2.0}) {
    if (step * power <= longest * (1.0 + 1e-9)) return step * power;
  }
  return power;
}

std::string with_micro_sign(double length) {
  const auto [number, prefix, scale] = with_prefix(length);
  return fmt::format("{:.3g} {}m", number, prefix == "u" ? "µ" : prefix);
}

double picture_scale(double side) {
  if (!(side > 0.0) || !std::isfinite(side)) {
    throw InputError(fmt::format("picture of a microstructure: the side of the box must be positive, got {} m", side));
  }
  return drawn_side / side;
}

std::string framed_picture(double side, std::string_view content, std::string_view style, std::string_view shapes) {
  const double scale = picture_scale(side);
  const double bar = scale_bar_length(side);
  return fmt::format(
             R"svg(<svg xmlns="http://www.w3.org/2000/svg" viewBox="{0} {0} {1} {2}" font-family="sans-serif" role="img" aria-labelledby="title">
<title id="title">Microstructure: {3} in a box of {4}</title>
<clipPath id="box"><rect width="{5}" height="{5}"/></clipPath>
<rect x="{0}" y="{0}" width="{1}" height="{2}" fill="#fff"/>
<rect width="{5}" height="{5}" fill="{7}"/>
<g clip-path="url(#box)" {6}>
)svg",
             -margin, drawn_side + 2.0 * margin, drawn_side + 2.0 * margin + strip, content, with_micro_sign(side),
             drawn_side, style, matrix_colour)
      .append(shapes)
      .append(fmt::format(
          R"svg(</g>
<rect width="{0}" height="{0}" fill="none" stroke="#222" stroke-width="2"/>
<rect id="scale-bar" y="{1}" width="{2:.6g}" height="10" fill="#222"/>
<text x="{3:.6g}" y="{4}" font-size="40" fill="#222">{5}</text>
</svg>
)svg",
          drawn_side, drawn_side + 40.0, bar * scale, bar * scale + 18.0, drawn_side + 59.0, with_micro_sign(bar)));
}

}  // namespace breccia
