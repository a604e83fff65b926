#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "breccia/microstructure/index.hpp"
#include "breccia/microstructure/microstructure.hpp"
#include "breccia/microstructure/vector.hpp"

namespace breccia::gaps {

// Places and lengths are in units of the cell side.

/// A piece of a line, from one place on it to another.
struct Interval {
  double begin, end;
  [[nodiscard]] double length() const noexcept { return end - begin; }
};

/// A line along an axis, on which places are measured from an origin.
struct GridLine {
  Vector<2> origin;
  std::size_t axis;

  [[nodiscard]] Vector<2> at(double place) const noexcept {
    auto point = origin;
    point[axis] += place;
    return point;
  }
};

/// A number of a particle among those of a box and their images.
using ImageIndex = std::int32_t;
inline constexpr ImageIndex no_image = -1;

/// The particles that are nearest to a point, and their distances, negative inside.
struct NearestTwo {
  ImageIndex first = no_image, second = no_image;
  double to_first = std::numeric_limits<double>::infinity(), to_second = std::numeric_limits<double>::infinity();

  /// Width of the gap between both at the point.
  [[nodiscard]] double gap() const noexcept { return to_first + to_second; }
};

/// The discs of a periodic box and their images, in units of the cell side, in an order that is the same around every
/// image of a point. It knows all discs that are near to a point in the box or up to `margin` cells outside.
class DiscImages {
 public:
  static constexpr int margin = 5;

  DiscImages(const Microstructure<2>& microstructure, int cells);

  [[nodiscard]] int cells() const noexcept { return cells_; }
  /// The particle of the microstructure of which this is an image.
  [[nodiscard]] std::size_t particle(ImageIndex image) const noexcept { return of(image).particle; }
  [[nodiscard]] Disc disc(ImageIndex image) const noexcept { return of(image).disc; }
  /// Distance of a point from a particle, negative inside.
  [[nodiscard]] double distance(ImageIndex image, const Vector<2>& point) const noexcept;
  /// The gradient of that distance; zero at the centre.
  [[nodiscard]] Vector<2> normal(ImageIndex image, const Vector<2>& point) const noexcept;
  /// The particles that may be at a point or within a few cells around it.
  [[nodiscard]] std::span<const ImageIndex> near(const Vector<2>& point) const noexcept;
  /// The two of these particles that are nearest. Of two particles as near the first one in the order is taken.
  [[nodiscard]] NearestTwo nearest_two(const Vector<2>& point) const noexcept;
  /// The unit vector across the gap between two particles, towards the second one; zero where there is no gap because
  /// both lie in the same direction.
  [[nodiscard]] Vector<2> across(ImageIndex one, ImageIndex other, const Vector<2>& point) const noexcept;
  /// The piece of a line in a particle.
  [[nodiscard]] std::optional<Interval> chord(ImageIndex image, const GridLine& line) const noexcept;
  /// The pieces of a line from its origin to the place 1 that lie in no particle.
  [[nodiscard]] std::vector<Interval> binder_on(const GridLine& line) const;

 private:
  struct Image {
    Disc disc;
    std::size_t particle;
  };
  [[nodiscard]] const Image& of(ImageIndex image) const noexcept { return images_[static_cast<std::size_t>(image)]; }
  [[nodiscard]] std::size_t bin_of(const Vector<2>& point) const noexcept;

  int cells_;
  std::vector<Image> images_;
  std::vector<std::size_t> first_of_bin_;  ///< where the images near a cell begin, by cell in rows, margins included
  std::vector<ImageIndex> in_bins_;
};

}  // namespace breccia::gaps
