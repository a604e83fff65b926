#pragma once

#include <cstddef>
#include <functional>

#include "breccia/discretisation/discretisation.hpp"

namespace breccia {

/// What is at a place of a microstructure.
struct PhaseAt {
  PhaseIndex phase = 0;
  /// Radius of a ball around the place that holds nothing but this phase [m]; 0 where that is not known. Interfaces
  /// are found sooner, and thin parts with certainty, where it is.
  double clearance = 0.0;
};

/// A microstructure of any kind: what is at a position [m].
template <int dim>
using Labelling = std::function<PhaseAt(const Vector<dim>& position)>;

/// The points of a microstructure in some layers of cells: every point has the phase at its place. Instantiated for 2
/// and 3 dimensions.
template <int dim>
[[nodiscard]] Discretisation<dim> discretise(const Grid<dim>& grid, const Labelling<dim>& labelling,
                                             const CellLayers& layers = {});

/// Parts of a square cell along each axis, at whose centres mixed cells of a labelling ask for its phases.
inline constexpr int label_subdivisions = 32;
/// The same for a cubic cell, whose parts are many: about as accurate.
inline constexpr int cube_label_subdivisions = 8;

/// A microstructure of mixed cells (theory, Eq. 40). The fractions of a cell that an interface crosses are the shares
/// of its label_subdivisions^2 (in 3D cube_label_subdivisions^3) parts: those of a straight interface are off by 0.002
/// in the mean square and by less than 1/32 at most, those of a flat one in 3D by 0.003 and 1/8. Then they are rounded
/// to multiples of 1 / mixture_steps. `phases` is the number of phases, which the numbers of the mixtures follow.
/// Throws InputError when a phase is beyond that number, or when there are more mixtures than a PhaseIndex can number.
[[nodiscard]] Discretisation<2> discretise_mixed(const Grid<2>& grid, const Labelling<2>& labelling, std::size_t phases,
                                                 const CellLayers& layers = {});
[[nodiscard]] Discretisation<3> discretise_mixed(const Grid<3>& grid, const Labelling<3>& labelling, std::size_t phases,
                                                 const CellLayers& layers = {});

}  // namespace breccia
