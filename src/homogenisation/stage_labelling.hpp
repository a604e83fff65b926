#pragma once

#include <vector>

#include "breccia/discretisation/discretisation.hpp"
#include "breccia/discretisation/labels.hpp"
#include "breccia/homogenisation/stage_microstructure.hpp"
#include "breccia/study/stage.hpp"

namespace breccia {

/// The phases of each filler of a stage, by the numbers of phases_of().
[[nodiscard]] std::vector<ParticlePhases> phases_of_fillers(const Stage& stage);

/// The phase of each label of an image: that of the matrix, then those of the fillers.
[[nodiscard]] std::vector<PhaseIndex> phases_of_labels(const Stage& stage);

/// What is at the places of grains or of particles that are not all discs, in a box of two dimensions.
[[nodiscard]] Labelling<2> labelling_in_plane(const Stage& stage, const StageMicrostructure& packed);

/// What is at the places of a box of three dimensions with anything but spheres. Throws InputError where there is
/// nothing of that kind.
[[nodiscard]] Labelling<3> labelling_in_space(const Stage& stage, const StageMicrostructure& packed);

}  // namespace breccia
