#pragma once

#include <cstddef>

#include "breccia/microstructure/label_image.hpp"

namespace breccia {

// Lines of pixels along the axes of an image. Instantiated for 2 and 3 dimensions. Label 0 is that of the matrix.

/// Runs of pixels of one kind along rows, columns and, in three dimensions, lines along z: intercepts of stereology.
struct Intercepts {
  double mean_filler = 0.0;         ///< mean length of the runs of filler [pixels]; 0 without
  std::size_t gaps = 0;             ///< number of runs of matrix with filler at both ends
  std::size_t narrow_gaps = 0;      ///< those of them that are shorter than a limit
  std::size_t isolated_pixels = 0;  ///< pixels with another label than all of their 2 dim neighbours
};

/// The intercepts of an image; gaps count as narrow below this length [pixels].
template <int dim>
[[nodiscard]] Intercepts intercepts_of(const LabelImage<dim>& image, double narrow);

}  // namespace breccia
