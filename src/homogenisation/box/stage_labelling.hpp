#pragma once

#include <vector>

#include "breccia/discretisation/discretisation.hpp"
#include "breccia/homogenisation/stage_microstructure.hpp"
#include "breccia/study/stage.hpp"

#include "discretisation/labels.hpp"

namespace breccia {

/// The phases of each filler of a stage, by the numbers of phases_of().
[[nodiscard]] std::vector<ParticlePhases> phases_of_fillers(const Stage& stage);

/// The phase of each label of an image: that of the matrix, then those of the fillers.
[[nodiscard]] std::vector<PhaseIndex> phases_of_labels(const Stage& stage);

/// The phases at the positions of a box of grains, of particles that are not all balls, or of pixels. Templates are
/// instantiated for 2 and 3 dimensions.
template <int dim>
[[nodiscard]] Labelling<dim> labelling_of(const Stage& stage, const Grains<dim>& grains);
[[nodiscard]] Labelling<2> labelling_of(const Stage& stage, const ParticleBox& particles);
[[nodiscard]] Labelling<3> labelling_of(const Stage& stage, const EllipsoidBox& ellipsoids);
template <int dim>
[[nodiscard]] Labelling<dim> labelling_of(const Stage& stage, const SharedImage<dim>& image);

}  // namespace breccia
