#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "breccia/discretisation/boundary.hpp"
#include "breccia/discretisation/discretisation.hpp"
#include "breccia/microstructure/index.hpp"
#include "breccia/microstructure/vector.hpp"

#include "discretisation/gaps/line.hpp"
#include "discretisation/gaps/plane/outline.hpp"
#include "discretisation/gaps/space/sphere_outline.hpp"

namespace breccia::gaps {

// Places and lengths are in units of the cell side.

/// A number of a particle among those of a box and their images.
using ImageIndex = std::int32_t;
inline constexpr ImageIndex no_image = -1;
/// The sides of a box whose nodes follow the load are as the surface of a particle around it.
inline constexpr ImageIndex walls = -2;
[[nodiscard]] constexpr bool is_particle(ImageIndex image) noexcept {
  return image >= 0;
}

/// The particles that are nearest to a point, and their distances, negative inside.
struct NearestTwo {
  ImageIndex first = no_image, second = no_image;
  double to_first = std::numeric_limits<double>::infinity(), to_second = std::numeric_limits<double>::infinity();

  /// Width of the gap between both at the point.
  [[nodiscard]] double gap() const noexcept { return to_first + to_second; }
};

/// The particles of a box, in units of the cell side, and their images if it is periodic, in an order that is the same
/// around every image of a point. Coatings belong to particles. It knows all particles that are near to a point in the
/// box or up to margin() cells outside. Under a displacement boundary it has walls, too.
template <int dim>
class ParticleImages {
 public:
  using Outline = std::conditional_t<dim == 2, gaps::Outline, SphereOutline>;

  /// Throws InputError unless the boundary is periodic for a periodic box, and for no other.
  ParticleImages(const ParticlesInBox<dim>& particles, int cells, Boundary boundary);

  [[nodiscard]] int cells() const noexcept { return cells_; }
  [[nodiscard]] bool is_periodic() const noexcept { return boundary_ == Boundary::periodic; }
  [[nodiscard]] bool has_walls() const noexcept { return boundary_ == Boundary::displacement; }
  /// Number of cells around the box whose particles are known; none but in a periodic box.
  [[nodiscard]] int margin() const noexcept { return is_periodic() ? 5 : 0; }
  /// The nodes of the box; of a periodic one without those that are images of others.
  [[nodiscard]] IndexRange<dim> nodes() const noexcept { return {{}, equal(cells_ + (is_periodic() ? 0 : 1))}; }
  /// Whether a cell, or an image of it, is in the box.
  [[nodiscard]] bool has_cell(const Index<dim>& cell) const noexcept {
    return is_periodic() || IndexRange<dim>{{}, equal(cells_)}.contains(cell);
  }
  /// The piece of a line in the box, without end in a periodic one.
  [[nodiscard]] Interval inside(const GridLine<dim>& line) const noexcept;
  /// The particle of the microstructure of which this is an image.
  [[nodiscard]] std::size_t particle(ImageIndex image) const noexcept { return of(image).particle; }
  [[nodiscard]] const Outline& outline(ImageIndex image) const noexcept { return of(image).outline; }
  /// Area or volume of a particle, and of it without its coating, in the cell of side 1 with this lowest corner.
  [[nodiscard]] double content(ImageIndex image, const Vector<dim>& corner) const {
    return of(image).outline.content_of_cell(corner);
  }
  [[nodiscard]] double content_of_core(ImageIndex image, const Vector<dim>& corner) const;
  /// Distance of a point from a particle or from the walls, negative inside the particle.
  [[nodiscard]] double distance(ImageIndex image, const Vector<dim>& point) const;
  /// The gradient of that distance; zero at the centre.
  [[nodiscard]] Vector<dim> normal(ImageIndex image, const Vector<dim>& point) const;
  /// The particles, and the walls, that may be at a point or within a few cells around it.
  [[nodiscard]] std::span<const ImageIndex> near(const Vector<dim>& point) const noexcept;
  /// The two of these particles that are nearest. Of two particles as near the first one in the order is taken.
  [[nodiscard]] NearestTwo nearest_two(const Vector<dim>& point) const;
  /// The unit vector across the gap between two particles, towards the second one; zero where there is no gap because
  /// both lie in the same direction.
  [[nodiscard]] Vector<dim> across(ImageIndex one, ImageIndex other, const Vector<dim>& point) const;
  /// The piece of a line in a particle.
  [[nodiscard]] std::optional<Interval> chord(ImageIndex image, const GridLine<dim>& line) const;
  /// The pieces of a line between two places, a whole number apart, that lie in the box and in no particle.
  [[nodiscard]] std::vector<Interval> binder_on(const GridLine<dim>& line, const Interval& within = {0.0, 1.0}) const;

 private:
  [[nodiscard]] static Index<dim> equal(int along) noexcept {
    Index<dim> index;
    index.fill(along);
    return index;
  }
  struct Image {
    Outline outline;
    std::optional<Outline> core;  ///< the particle without its coating, if it has one
    std::size_t particle = 0;
  };
  [[nodiscard]] const Image& of(ImageIndex image) const noexcept { return images_[static_cast<std::size_t>(image)]; }
  [[nodiscard]] std::vector<Vector<dim>> shifts_of_images(const Outline& outline) const;
  /// Calls action(bin, image) for the images that are near to a cell, and for the walls.
  template <class Action>
  void for_images_near_cells(const Action& action) const;
  void sort_into_bins();
  [[nodiscard]] std::size_t bin_of(const Vector<dim>& point) const noexcept;

  /// A side of the box and the distance of a point from it.
  struct Side {
    std::size_t axis;
    double inwards, distance;  ///< inwards: the component of its normal along the axis
  };
  [[nodiscard]] Side nearest_side(const Vector<dim>& point) const noexcept;

  int cells_;
  Boundary boundary_;
  std::vector<Image> images_;
  std::vector<std::size_t> first_of_bin_;  ///< where the images near a cell begin, by cell in rows, margins included
  std::vector<ImageIndex> in_bins_;
};

extern template class ParticleImages<2>;
extern template class ParticleImages<3>;

}  // namespace breccia::gaps
