#pragma once

#include <variant>

#include "breccia/microstructure/microstructure.hpp"
#include "breccia/microstructure/shaped_particles.hpp"
#include "breccia/study/stage.hpp"

namespace breccia {

/// The box of listed particles: of discs or spheres, or of particles of other shapes with their coatings.
template <int dim>
using ListedBox = std::variant<Microstructure<dim>, ShapedParticles<dim>>;

/// The listed particles of a stage in their box. Instantiated for 2 and 3 dimensions.
template <int dim>
ListedBox<dim> listed_box(const Stage& stage, const ExplicitPacking<dim>& listed);

/// Throws InputError where listed particles of a stage, with their coatings, overlap or cross a wall. Instantiated for
/// 2 and 3 dimensions.
template <int dim>
void require_room(const Stage& stage, const ListedBox<dim>& box);

}  // namespace breccia
