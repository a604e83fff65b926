#pragma once

#include <cstddef>
#include <string_view>
#include <variant>
#include <vector>

#include "breccia/discretisation/discretisation.hpp"
#include "breccia/discretisation/phases.hpp"
#include "breccia/homogenisation/stage_microstructure.hpp"
#include "breccia/quasistatic/reduced_response.hpp"
#include "breccia/study/phase_names.hpp"
#include "breccia/study/stage.hpp"

namespace breccia {

/// The phases of a stage: its matrix, and one for each material of its fillers and their coatings (phase_names).
Phases phases_of(const Stage& stage);

/// The materials of these phases, by PhaseIndex. `matrix` is the material of the matrix, which may be the result of an
/// earlier stage.
std::vector<Material> materials_of(const Stage& stage, const Material& matrix);

/// The material points of a stage, in two or in three dimensions.
using StageDiscretisation = std::variant<Discretisation<2>, Discretisation<3>>;

/// Discretises a stage with these particles on `cells` cells along each side of its box, or on some layers of these
/// cells. The points have the phases of the stage (phases_of); in cells that an interface crosses they are as `mixing`
/// says. Throws InputError when a particle belongs to no filler of the stage. Instantiated for 2 and 3 dimensions.
template <int dim>
Discretisation<dim> discretise(const Stage& stage, const Microstructure<dim>& microstructure, int cells, Mixing mixing,
                               const CellLayers& layers = {});

/// Discretises a stage whose box is filled by particles, grains or pixels. Instantiated for 2 and 3 dimensions.
template <int dim>
Discretisation<dim> discretise(const Stage& stage, const Box<dim>& box, int cells, Mixing mixing,
                               const CellLayers& layers = {});
/// Mixing::flow is Mixing::series here where the gaps of the stage are wide.
StageDiscretisation discretise(const Stage& stage, const StageMicrostructure& packed, int cells, Mixing mixing,
                               const CellLayers& layers = {});

/// As discretise() above, but all processes of a machine make the discretisation together and share one copy in memory.
/// Every process of the group must call the function.
StageDiscretisation discretise_together(const Stage& stage, const StageMicrostructure& packed, int cells,
                                        Mixing mixing);

/// Fractions of the phases 0 .. phases - 1 [-].
std::vector<double> fractions(const StageDiscretisation& discretisation, std::size_t phases);

/// Number of cells along each side.
int cells_along(const StageDiscretisation& discretisation);

/// Number of material points of a stage on `cells` cells along each side of its box.
std::size_t point_count(const Stage& stage, int cells);

}  // namespace breccia
