#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "rasters/png.hpp"

namespace breccia {

/// A picture in PNG (encode_png) as the address of an SVG image that needs no file.
std::string embedded_png(std::size_t width, std::span<const std::uint8_t> pixels, std::span<const Rgb> palette);

}  // namespace breccia
