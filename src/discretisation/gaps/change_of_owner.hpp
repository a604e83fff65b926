#pragma once

#include "discretisation/gaps/particle_images.hpp"

namespace breccia::gaps {

/// The place, from 0 to 1, on a line between two nodes as far from the particle of the first node as from that of the
/// second one. Where one particle is nearer all along the line it is the end at the other one's node.
template <int dim>
[[nodiscard]] double change_of_owner(const ParticleImages<dim>& images, ImageIndex first, ImageIndex second,
                                     const GridLine<dim>& line);

}  // namespace breccia::gaps
