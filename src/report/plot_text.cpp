#include "report/plot_text.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "report/markup.hpp"

namespace breccia {

double plot_text_width(std::string_view text, double font_size) {
  constexpr double width_of_a_sign = 0.6;  // width as a share of the size of the font
  constexpr unsigned continuation = 0x80, continuation_mask = 0xc0;
  // The bytes of UTF-8 that begin a sign.
  const auto signs = std::ranges::count_if(
      text, [](char byte) { return (static_cast<unsigned char>(byte) & continuation_mask) != continuation; });
  return width_of_a_sign * font_size * static_cast<double>(signs);
}

std::string plot_text(double x, double y, std::string_view text, double widest, std::string_view attributes,
                      double font_size) {
  std::string printable(text);
  std::ranges::replace_if(
      printable, [](unsigned char byte) { return byte < 0x20 || byte == 0x7f; }, ' ');
  const bool is_too_wide = plot_text_width(printable, font_size) > widest;
  return fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\"{}{}{}>{}</text>\n", x, y, attributes.empty() ? "" : " ",
                     attributes,
                     is_too_wide ? fmt::format(R"( textLength="{:.0f}" lengthAdjust="spacingAndGlyphs")", widest) : "",
                     as_markup(printable));
}

}  // namespace breccia
