#pragma once

#include <vector>

#include <Eigen/Core>

#include "breccia/microstructure/tessellation.hpp"

#include "films/space/cell_complex.hpp"

namespace breccia::films {

/// A grain as its cell made smaller: the point x of the cell is at scale x + shift. Lengths are in sides of the box.
struct ShrunkGrain {
  double scale;
  Eigen::Vector3d shift;

  /// The place in a grain, displaced by whole sides of the box, of a point of its cell there.
  [[nodiscard]] Eigen::Vector3d place(const Eigen::Vector3d& point, const Eigen::Vector3i& image) const {
    const Eigen::Vector3d sides = image.cast<double>();
    return scale * (point - sides) + shift + sides;
  }
};

/// The grains of a tessellation that fill this fraction of the box, by cell. Their faces are parallel to those of the
/// cells and recede from them by nearly the same distance (theory, Eq. 69a).
/// Throws InputError, with all the sites, when a grain vanishes or reaches into another one.
[[nodiscard]] std::vector<ShrunkGrain> shrunk_grains(const Tessellation<3>& tessellation, const CellComplex& complex,
                                                     double fraction);

}  // namespace breccia::films
