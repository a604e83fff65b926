#pragma once

#include <string>
#include <string_view>

namespace breccia {

/// The sizes of the texts of a plot, in units of the drawing.
inline constexpr double plot_font_size = 15.0;
inline constexpr double small_plot_font_size = 11.0;
/// Distance from the base line of a text to its middle.
inline constexpr double middle_of_plot_text = 5.0;

/// The width of a text in a sans-serif font, estimated rather too large than too small: the fonts of browsers differ.
double plot_text_width(std::string_view text, double font_size = plot_font_size);

/// A text at a position, squeezed to a width where it would be wider. `attributes` are further attributes of the
/// element; control characters become spaces.
std::string plot_text(double x, double y, std::string_view text, double widest, std::string_view attributes = "",
                      double font_size = plot_font_size);

}  // namespace breccia
