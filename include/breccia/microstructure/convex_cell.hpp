#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "breccia/microstructure/vector.hpp"

namespace breccia {

// Instantiated for 2 and 3 dimensions. In 2D a volume is an area and the measure of a face is a length.

/// The points x with normal . x <= offset.
template <int dim>
struct HalfSpace {
  Vector<dim> normal;    ///< outward normal of the plane that bounds the half-space, of length 1 [-]
  double offset;         ///< distance of this plane from the origin, along the normal [m]
  std::uint32_t behind;  ///< number that the caller gives to the neighbour or wall behind this plane

  /// Height of a point above the plane [m]; negative inside.
  [[nodiscard]] double height(const Vector<dim>& point) const noexcept {
    double height = -offset;
    for (std::size_t axis = 0; axis < normal.size(); ++axis) height += normal[axis] * point[axis];
    return height;
  }
};

/// A convex polygon or polyhedron from which half-spaces cut parts off. Its corners are simple: `dim` planes meet in
/// each. Planes that pass through a corner within roundoff cut nothing.
template <int dim>
class ConvexCell {
 public:
  struct Corner {
    Vector<dim> position;  ///< [m]
    /// Numbers of the planes that meet in the corner. In 2D they run counter-clockwise: the corner is the end of the
    /// first edge and the beginning of the second.
    std::array<std::uint32_t, static_cast<std::size_t>(dim)> planes;
  };

  /// The numbers HalfSpace::behind of the lower and upper side of a box along each axis.
  using BoxSides = std::array<std::array<std::uint32_t, 2>, static_cast<std::size_t>(dim)>;

  ConvexCell() = default;
  /// The box between two corners [m].
  ConvexCell(const Vector<dim>& lower, const Vector<dim>& upper, const BoxSides& behind);

  [[nodiscard]] bool is_empty() const noexcept { return corners_.empty(); }
  [[nodiscard]] std::span<const Corner> corners() const noexcept { return corners_; }
  /// The half-spaces that bound the cell. Before trim() they include those whose face has been cut off.
  [[nodiscard]] std::span<const HalfSpace<dim>> half_spaces() const noexcept { return half_spaces_; }
  /// Largest distance of a corner from the origin [m].
  [[nodiscard]] double reach() const noexcept;
  /// Number of the corner at the other end of an edge: of the edge that leads from a corner away from the corner's
  /// plane `slot`.
  [[nodiscard]] std::size_t corner_across(std::size_t corner, std::size_t slot) const noexcept;

  /// Cuts off the part outside the half-space. Returns false if there is none.
  bool cut(const HalfSpace<dim>& half_space);
  /// Removes the half-spaces without a face, and renumbers the remaining ones.
  void trim();
  /// The cell of the points whose distance from all faces is at least `distance` [m].
  [[nodiscard]] ConvexCell eroded(double distance) const;
  /// The cell of the points whose distance from each face is at least distance(face) [m]; faces at distance 0 stay.
  [[nodiscard]] ConvexCell eroded(const std::function<double(const HalfSpace<dim>&)>& distance) const;

 private:
  std::vector<Corner> corners_;
  std::vector<HalfSpace<dim>> half_spaces_;
  double tolerance_ = 0.0;  // height of a corner above a plane that is roundoff [m]
};

/// Volume of a cell [m^dim].
template <int dim>
[[nodiscard]] double volume(const ConvexCell<dim>& cell);

/// Area (2D: length) of the face of each half-space [m^(dim - 1)].
template <int dim>
[[nodiscard]] std::vector<double> face_measures(const ConvexCell<dim>& cell);

template <int dim>
/// Volume, centroid and covariance of a cell.
struct Moments {
  double volume = 0.0;     ///< volume [m^dim]
  Vector<dim> centroid{};  ///< centroid [m]
  /// Covariance of the positions of the points in the cell [m^2].
  std::array<Vector<dim>, static_cast<std::size_t>(dim)> covariance{};
};

/// Volume and centroid of a cell, and the covariance of its points about the centroid. Zeros for an empty cell.
template <int dim>
[[nodiscard]] Moments<dim> moments(const ConvexCell<dim>& cell);

/// Square root of the ratio of the largest to the smallest principal covariance [-]: the ratio of the axes, for an
/// ellipse. 1 for an empty cell.
template <int dim>
[[nodiscard]] double aspect_ratio(const Moments<dim>& moments);

/// The corners of a cell in two dimensions, counter-clockwise [m].
[[nodiscard]] std::vector<Vector<2>> polygon(const ConvexCell<2>& cell);

}  // namespace breccia
