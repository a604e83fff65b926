#pragma once

#include <cstddef>
#include <span>

#include "breccia/discretisation/discretisation.hpp"
#include "breccia/microstructure/label_image.hpp"

namespace breccia {

// Functions that make the material points of an image of labels, which fills the box of a grid. Cells may be larger or
// smaller than pixels, and their sides need not coincide with those of pixels: positions are counted in whole numbers,
// so that nothing is rounded. `phases` holds the phase of each label. All functions throw InputError when the image is
// not valid or a label has no phase.

/// Discretises an image: every point has the phase of the pixel that contains it; a point on the border of two pixels
/// belongs to the pixel with the greater coordinate. Instantiated for 2 and 3 dimensions.
template <int dim>
[[nodiscard]] Discretisation<dim> discretise(const Grid<dim>& grid, const LabelImage<dim>& image,
                                             std::span<const PhaseIndex> phases, const CellLayers& layers = {});

/// The function for two dimensions, for arguments in braces, from which the dimension cannot be deduced.
[[nodiscard]] inline Discretisation<2> discretise(const Grid<2>& grid, const LabelImage<2>& image,
                                                  std::span<const PhaseIndex> phases) {
  return discretise<2>(grid, image, phases);
}

/// Discretises an image into mixed cells: a cell with pixels of several phases is a mixture (theory, Eq. 40) by the
/// areas (volumes) of the pixels in it, which are exact except for the rounding to mixture_steps. `phase_count` is the
/// number of phases, which the numbers of the mixtures follow. Throws InputError, too, when there are more mixtures
/// than a PhaseIndex can number. Instantiated for 2 and 3 dimensions.
template <int dim>
[[nodiscard]] Discretisation<dim> discretise_mixed(const Grid<dim>& grid, const LabelImage<dim>& image,
                                                   std::span<const PhaseIndex> phases, std::size_t phase_count,
                                                   const CellLayers& layers = {});

}  // namespace breccia
