#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "results/meshes/length_unit.hpp"
#include "results/study_document.hpp"

namespace breccia {

struct SurfaceSettings {
  double longest_edge = 0.1;  ///< of a triangle of a sphere, as a share of its diameter (divided_icosahedron)
  std::string material = {};  ///< material of the particles; empty: all
  LengthUnit unit = LengthUnit::metre;
};

/// What a file of surfaces holds.
struct SurfaceCounts {
  std::size_t particles = 0, triangles = 0;
  std::size_t across_sides = 0;  ///< number of particles that reach beyond the sides of the box
  double enclosed = 0.0;         ///< volume inside the surfaces over that of the box [-]
  double fraction = 0.0;         ///< volume of the particles over that of the box [-]
};

/// Throws InputError, with the reason and with what is there instead, unless a stage has particles in space, and some
/// of the material that the settings ask for.
void require_surfaces(const StageEntry& stage, const SurfaceSettings& settings);

/// Writes the surfaces of the particles of a stage, or of its grains without films, as a binary STL file. Each particle
/// is written once, whole and at its place. `directory` is that of the stage in its results. Throws FileError, and
/// InputError as require_surfaces() and the readers of stored geometry do.
SurfaceCounts write_surfaces(const std::filesystem::path& file, const std::filesystem::path& directory,
                             const StageEntry& stage, const SurfaceSettings& settings);

}  // namespace breccia
