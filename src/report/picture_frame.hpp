#pragma once

#include <string>
#include <string_view>

namespace breccia {

/// Side of the box in a picture of a microstructure, in the units of the drawing.
inline constexpr double drawn_side = 1000.0;

/// Colour of the box, where nothing is drawn above it.
inline constexpr std::string_view matrix_colour = "#f3e9d8";
inline constexpr std::string_view debonded_colour = "#d92d20";  ///< of films that are debonded

/// Units of the drawing per metre for a box of this side [m]. Throws InputError if it is not positive and finite.
double picture_scale(double side);

/// The length of a scale bar: the longest of 1, 2, 5 times a power of ten that is at most a quarter of the side [m].
double scale_bar_length(double side);

/// A length as text: "500 µm".
std::string with_micro_sign(double length);

/// SVG picture of a box with a scale bar below. `shapes` are the elements inside, in the units of the drawing with y
/// downwards, clipped at its sides; `style` are their common attributes; `content` is the subject in the title.
std::string framed_picture(double side, std::string_view content, std::string_view style, std::string_view shapes);

}  // namespace breccia
