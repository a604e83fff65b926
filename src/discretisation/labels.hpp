#pragma once

#include <cstddef>
#include <functional>

#include "breccia/discretisation/discretisation.hpp"

namespace breccia {

/// The phase at a position of a microstructure.
struct PhaseAt {
  PhaseIndex phase = 0;
  /// Radius of a ball around the position that contains this phase alone [m]; 0 where it is not known. Where it is
  /// known, interfaces are found sooner, and thin parts with certainty.
  double clearance = 0.0;
};

/// A microstructure of any kind: a function that returns the phase at a position [m].
template <int dim>
using Labelling = std::function<PhaseAt(const Vector<dim>& position)>;

/// The points of a microstructure in some layers of cells: every point has the phase at its position. Instantiated for
/// 2 and 3 dimensions.
template <int dim>
[[nodiscard]] Discretisation<dim> discretise(const Grid<dim>& grid, const Labelling<dim>& labelling,
                                             const CellLayers& layers = {});

/// Number of parts of a square cell along each axis; the phases of a mixed cell are those at the centres of its parts.
inline constexpr int label_subdivisions = 32;
/// Number of parts of a cubic cell along each axis, with about the accuracy of those of a square cell.
inline constexpr int cube_label_subdivisions = 8;

/// A microstructure of mixed cells (theory, Eq. 40). The fractions of a cell that an interface crosses are the shares
/// of its label_subdivisions^2 (in 3D cube_label_subdivisions^3) parts: the error at a straight interface is 0.002 in
/// the root mean square and below 1/32, that at a flat one in 3D 0.003 and below 1/8. Then they are rounded to
/// multiples of 1 / mixture_steps. The numbers of the mixtures follow those of the `phases` phases. Throws InputError
/// when a phase is beyond that number, or when there are more mixtures than a PhaseIndex can number.
[[nodiscard]] Discretisation<2> discretise_mixed(const Grid<2>& grid, const Labelling<2>& labelling, std::size_t phases,
                                                 const CellLayers& layers = {});
[[nodiscard]] Discretisation<3> discretise_mixed(const Grid<3>& grid, const Labelling<3>& labelling, std::size_t phases,
                                                 const CellLayers& layers = {});

}  // namespace breccia
