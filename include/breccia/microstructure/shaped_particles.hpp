#pragma once

#include <type_traits>

#include "breccia/microstructure/ellipsoid_box.hpp"
#include "breccia/microstructure/particle_box.hpp"

namespace breccia {

/// A particle of any shape that a box of `dim` dimensions can hold.
template <int dim>
using ShapedParticle = std::conditional_t<dim == 2, Particle, Ellipsoid>;

/// A box of particles that are not all balls, with their coatings.
template <int dim>
using ShapedParticles = std::conditional_t<dim == 2, ParticleBox, EllipsoidBox>;

}  // namespace breccia
