#pragma once

#include <cstddef>
#include <vector>

#include "breccia/checkpoint/state.hpp"
#include "breccia/microstructure/particle_box.hpp"
#include "breccia/study/stage.hpp"

namespace breccia {

/// Writes the shapes and the places of particles to a state, without their fillers. Throws FileError.
void save_particles(StateWriter& state, const std::vector<Particle>& particles);

/// Whether a state has such particles.
bool has_particles(const StateReader& state);

/// Reads them. Throws FileError where they are none.
std::vector<Particle> read_particles(const StateReader& state);

}  // namespace breccia
