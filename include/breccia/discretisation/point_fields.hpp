#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "breccia/discretisation/discretisation.hpp"
#include "breccia/discretisation/tensor.hpp"

namespace breccia {

/// Fields at the material points, per unit of the load, in the order of their lattice (Grid::point_index): spacing h/2,
/// from the corner with the lowest coordinates. The points of a cell lie in neighbouring rows of it.
template <int dim>
struct PointFields {
  static constexpr std::size_t shears = dim * (dim - 1) / 2;

  std::vector<PhaseIndex> phase;          ///< in a mixed cell the phase with the largest share
  std::vector<Vector<dim>> displacement;  ///< [m]
  /// Normal components, then tensor shears in Voigt's order (2D: xx, yy, xy), as the stress depends on them [-].
  std::vector<std::array<double, dim + shears>> strain;
  /// The three normal components, also in plane strain, then the shears (2D: xx, yy, zz, xy) [Pa].
  std::vector<std::array<double, 3 + shears>> stress;
};

/// Fields at a time after the load was applied.
template <int dim>
struct TimedFields {
  double time = 0.0;  ///< [s]
  PointFields<dim> fields;
};

/// Fields of the points of a discretisation: their phases, and all else zero. Instantiated for 2 and 3 dimensions.
template <int dim>
[[nodiscard]] PointFields<dim> zero_fields(const Discretisation<dim>& discretisation);

}  // namespace breccia
