#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "rasters/png.hpp"

namespace breccia {

/// The colour of a text such as "#5b7f95".
Rgb parsed_colour(std::string_view text);

/// A picture in PNG (encode_png) as the address of an SVG image that needs no file.
std::string embedded_png(std::size_t width, std::span<const std::uint8_t> pixels, std::span<const Rgb> palette);

}  // namespace breccia
