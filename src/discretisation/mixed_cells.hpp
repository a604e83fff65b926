#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "breccia/discretisation/discretisation.hpp"
#include "breccia/microstructure/microstructure.hpp"
#include "breccia/viscoelasticity/material.hpp"

namespace breccia {

/// The number of steps between the fractions 0 and 1 of a phase in a mixed cell. Fractions are rounded to multiples of
/// 1 / mixture_steps, so that a grid has few different mixtures.
inline constexpr int mixture_steps = 64;

/// A microstructure of balls on `cells` cells along each axis. The points of a cell in one phase have that phase. A
/// cell that an interface crosses is a mixture of its phases by their fractions of its area (in 3D of its volume),
/// which are exact except for the rounding to mixture_steps. `particles` holds the phases of each ball, whose coatings
/// must not overlap; `phases` is the number of phases, which the numbers of the mixtures follow. Throws InputError when
/// a ball has no phase or one beyond that number, or when there are more mixtures than a PhaseIndex can number.
/// Instantiated for 2 and 3 dimensions.
template <int dim>
[[nodiscard]] Discretisation<dim> discretise_mixed(const Microstructure<dim>& microstructure, int cells,
                                                   PhaseIndex matrix, std::span<const ParticlePhases> particles,
                                                   std::size_t phases, const CellLayers& layers = {});

/// Overload for balls without coatings; `particles` holds the phase of each ball.
template <int dim>
[[nodiscard]] Discretisation<dim> discretise_mixed(const Microstructure<dim>& microstructure, int cells,
                                                   PhaseIndex matrix, std::span<const PhaseIndex> particles,
                                                   std::size_t phases);

/// The given materials, by PhaseIndex, followed by those of the mixtures, so that the numbers of the points of mixed
/// cells are indices into this list. Instantiated for 2 and 3 dimensions.
template <int dim>
[[nodiscard]] std::vector<Material> with_mixtures(const Discretisation<dim>& discretisation,
                                                  std::vector<Material> materials);

}  // namespace breccia
