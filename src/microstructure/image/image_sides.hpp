#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "breccia/microstructure/label_image.hpp"

namespace breccia {

// What the sides of an image cut. Instantiated for 2 and 3 dimensions. Label 0 is that of the matrix.

/// Share of the filler that the sides of an image cut [-]: all pixels of a filler that are connected with a side by
/// pixels of the same label. 0 without filler.
template <int dim>
[[nodiscard]] double cut_share(const LabelImage<dim>& image);

/// How well the opposite sides of an image fit together, as they do where it is one period of a periodic
/// microstructure. All numbers are of the axis whose sides fit worst.
struct Seam {
  double across = 0.0;       ///< share of the pixels at one side with another label than those at the opposite side [-]
  double most_inside = 0.0;  ///< the largest such share of two neighbouring rows, columns or layers inside [-]

  /// Whether the sides fit together as well as neighbouring lines of pixels do.
  [[nodiscard]] bool fits() const { return across <= most_inside; }
};

template <int dim>
[[nodiscard]] Seam seam_of(const LabelImage<dim>& image);

/// The largest number of rows, columns or layers at one side of a picture that have one value each, as those of a frame
/// or of the bar below a micrograph have. `extents` as in Raster. 0 where all pixels are equal.
[[nodiscard]] std::size_t frame_of(std::span<const std::int32_t> values, std::span<const std::size_t> extents);

}  // namespace breccia
