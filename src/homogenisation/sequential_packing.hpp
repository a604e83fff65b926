#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "breccia/microstructure/ellipsoid_box.hpp"
#include "breccia/microstructure/particle_box.hpp"
#include "breccia/microstructure/random_sequential.hpp"
#include "breccia/study/stage.hpp"

#include "drawn_particles.hpp"

namespace breccia {

/// The particles of a stage with a random sequential packing, with their shapes, coatings and gaps. They keep the whole
/// gap to a wall, too: the boundary there is as rigid as a particle.
RandomSequentialRequest sequential_request(const Stage& stage, const RandomSequentialPacking& method,
                                           const DrawnParticles& drawn);

/// The particles where they have been placed; `fillers` are the numbers of their fillers.
ParticleBox packed_box(const Stage& stage, const RandomSequentialRequest& request, const std::vector<Pose>& poses,
                       std::vector<std::size_t> fillers);

/// The same for the ellipsoids of a box of three dimensions.
EllipsoidSequentialRequest ellipsoid_request(const Stage& stage, const RandomSequentialPacking& method,
                                             const DrawnParticles& drawn);
EllipsoidBox packed_ellipsoids(const Stage& stage, const EllipsoidSequentialRequest& request,
                               const std::vector<EllipsoidPose>& poses, std::vector<std::size_t> fillers);

/// The message of a packing that failed in the terms of the deck.
std::string message_on(const Stage& stage, const RandomSequentialRequest& request, const PackingError& error);
std::string message_on(const Stage& stage, const EllipsoidSequentialRequest& request, const PackingError& error);

}  // namespace breccia
