#pragma once

#include <filesystem>

#include "breccia/microstructure/ellipsoid_box.hpp"
#include "breccia/microstructure/particle_box.hpp"
#include "breccia/study/stage.hpp"

namespace breccia {

/// Writes particles in the form that an explicit packing reads: ellipses to `microstructure.csv`, polygons, if there
/// are any, to `polygons.csv`. Throws FileError.
void write_particles(const std::filesystem::path& directory, const Stage& stage, const ParticleBox& box);

/// Writes ellipsoids to `microstructure.csv` in the form that an explicit packing reads. Throws FileError.
void write_ellipsoids(const std::filesystem::path& directory, const Stage& stage, const EllipsoidBox& box);

}  // namespace breccia
