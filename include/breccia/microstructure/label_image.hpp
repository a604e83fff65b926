#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "breccia/microstructure/index.hpp"
#include "breccia/microstructure/microstructure.hpp"
#include "breccia/microstructure/vector.hpp"

namespace breccia {

/// The number of a phase in an image.
using Label = std::uint16_t;

/// A box [0, pixels * pixel_side] of square pixels (2D) or cubic voxels (3D), each of one phase. x points to the right
/// and y upwards.
template <int dim>
struct LabelImage {
  Index<dim> pixels{};        ///< number of pixels along each axis
  double pixel_side = 0.0;    ///< [m]
  Walls walls = Walls::hard;  ///< whether the image continues periodically
  std::vector<Label> labels;  ///< x runs fastest, then y, then z

  /// The label of the pixel at a point [m]; a point on the border of two pixels belongs to the pixel with the greater
  /// coordinate. Outside of the box the image is continued: periodically, or with the nearest pixel. The image must be
  /// valid.
  [[nodiscard]] Label label_at(const Vector<dim>& point) const noexcept;

  friend bool operator==(const LabelImage&, const LabelImage&) = default;
};

/// An image that several objects share, since it is large.
template <int dim>
using SharedImage = std::shared_ptr<const LabelImage<dim>>;

extern template struct LabelImage<2>;
extern template struct LabelImage<3>;

/// The sides of the box [m].
template <int dim>
[[nodiscard]] Vector<dim> box_of(const LabelImage<dim>& image);

/// Whether the box is a square or a cube, as the solvers need it at present.
template <int dim>
[[nodiscard]] bool has_equal_sides(const LabelImage<dim>& image);

/// Throws InputError if an axis has no pixels, the side of a pixel is not positive and finite, or the labels do not
/// fill the box. Instantiated for 2 and 3 dimensions.
template <int dim>
void require_valid(const LabelImage<dim>& image);

}  // namespace breccia
