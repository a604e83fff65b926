#include "report/colour_map.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace breccia {
namespace {

/// The sRGB value of a light intensity, both 0 to 1 (IEC 61966-2-1).
std::uint8_t encoded(double light) {
  const double value = light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1.0 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(value, 0.0, 1.0)));
}

Rgb from_oklab(double lightness, double a, double b) {
  const auto cubed = [](double root) { return root * root * root; };
  const double l = cubed(lightness + 0.3963377774 * a + 0.2158037573 * b);
  const double m = cubed(lightness - 0.1055613458 * a - 0.0638541728 * b);
  const double s = cubed(lightness - 0.0894841775 * a - 1.2914855480 * b);
  return {encoded(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
          encoded(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
          encoded(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

}  // namespace

std::array<Rgb, 256> perceptual_colours() {
  constexpr double dark = 0.25, light = 0.95, violet = 305.0, yellow = 105.0;
  constexpr double chroma = 0.097;  // the largest chroma that sRGB has for all of these hues
  std::array<Rgb, 256> colours;
  for (std::size_t i = 0; i < colours.size(); ++i) {
    const double share = static_cast<double>(i) / (colours.size() - 1.0);
    const double hue = std::lerp(violet, yellow, share) * std::numbers::pi / 180.0;
    colours[i] = from_oklab(std::lerp(dark, light, share), chroma * std::cos(hue), chroma * std::sin(hue));
  }
  return colours;
}

std::array<Rgb, 256> diverging_colours() {
  constexpr double dark = 0.42, light = 0.96, blue = 262.0, red = 30.0;
  constexpr double chroma = 0.13;  // the largest that sRGB has for the darkest colours of both hues
  std::array<Rgb, 256> colours;
  for (std::size_t i = 0; i < colours.size(); ++i) {
    const double place = 2.0 * static_cast<double>(i) / (colours.size() - 1.0) - 1.0;
    const double size = std::abs(place);
    const double hue = (place < 0.0 ? blue : red) * std::numbers::pi / 180.0;
    colours[i] = from_oklab(std::lerp(light, dark, size), chroma * size * std::cos(hue), chroma * size * std::sin(hue));
  }
  return colours;
}

}  // namespace breccia
