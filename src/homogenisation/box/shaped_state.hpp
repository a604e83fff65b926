#pragma once

#include <cstddef>
#include <vector>

#include "breccia/microstructure/ellipsoid.hpp"
#include "breccia/microstructure/particle_box.hpp"
#include "breccia/study/stage.hpp"

#include "checkpoint/state.hpp"

namespace breccia {

/// Writes the shapes and the poses of particles to a state, without their fillers. Throws FileError.
void save_particles(StateWriter& state, const std::vector<Particle>& particles);

/// Writes ellipsoids to a state, without their fillers. Throws FileError.
void save_ellipsoids(StateWriter& state, const std::vector<Ellipsoid>& ellipsoids);

/// Whether a state has particles that save_particles() wrote (or ellipsoids that save_ellipsoids() wrote).
bool has_particles(const StateReader& state);
bool has_ellipsoids(const StateReader& state);

/// Reads particles (or ellipsoids) from a state. Throws FileError where the numbers do not describe any.
std::vector<Particle> read_particles(const StateReader& state);
std::vector<Ellipsoid> read_ellipsoids(const StateReader& state);

}  // namespace breccia
