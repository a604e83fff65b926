#pragma once

#include <cstddef>
#include <vector>

#include "breccia/microstructure/ellipsoid.hpp"
#include "breccia/microstructure/particle_box.hpp"
#include "breccia/study/stage.hpp"

#include "checkpoint/state.hpp"

namespace breccia {

/// Writes the shapes and the places of particles to a state, without their fillers. Throws FileError.
void save_particles(StateWriter& state, const std::vector<Particle>& particles);

/// The same of ellipsoids.
void save_ellipsoids(StateWriter& state, const std::vector<Ellipsoid>& ellipsoids);

/// Whether a state has such particles.
bool has_particles(const StateReader& state);
bool has_ellipsoids(const StateReader& state);

/// Reads them. Throws FileError where they are none.
std::vector<Particle> read_particles(const StateReader& state);
std::vector<Ellipsoid> read_ellipsoids(const StateReader& state);

}  // namespace breccia
