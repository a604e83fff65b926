#pragma once

#include <array>

#include "rasters/png.hpp"

namespace breccia {

/// Colours from dark violet over blue and green to light yellow in equal steps to the eye: lightness and hue change
/// evenly, at constant chroma, in the space Oklab (B. Ottosson, A perceptual color space for image processing, 2020).
std::array<Rgb, 256> perceptual_colours();

/// Colours from blue over light grey to red, in the same space: lightness falls and chroma rises evenly to both ends.
std::array<Rgb, 256> diverging_colours();

}  // namespace breccia
