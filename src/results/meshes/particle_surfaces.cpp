#include "results/meshes/particle_surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/microstructure/tessellation.hpp"

#include "io/nearest_name.hpp"
#include "results/meshes/closed_surface.hpp"
#include "results/meshes/stl_file.hpp"
#include "results/stored_geometry.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;

/// The material of the particles of a filler. Throws FileError where the stage has no such filler.
const std::string& material_of(const StageEntry& stage, std::size_t filler, const fs::path& directory) {
  if (filler < stage.fillers.size()) return stage.fillers[filler].material;
  throw FileError(fmt::format("{}: a particle is of filler {}, counted from 0, but the stage has only {}",
                              (directory / "microstructure.csv").string(), filler, stage.fillers.size()));
}

/// Adds surfaces to a file and to the counts.
class SurfaceWriter {
 public:
  SurfaceWriter(const fs::path& path, const StageEntry& stage, LengthUnit unit)
      : side_(stage.side),
        is_periodic_(stage.microstructure.sides.value_or(BoxSides::periodic) == BoxSides::periodic),
        file_(path, fmt::format("breccia: stage {}, lengths in {}", stage.name, name_of(unit)), units_per_metre(unit)) {
  }

  /// Adds the surface of a particle of this volume [m^3].
  void add(const ClosedSurface& surface, double volume) {
    const auto is_outside = [&](const Vector<3>& corner) {
      constexpr double rounding = 1e-9;
      return std::ranges::any_of(corner,
                                 [&](double x) { return x < -rounding * side_ || x > (1.0 + rounding) * side_; });
    };
    file_.add(surface);
    ++counts_.particles;
    if (is_periodic_ && std::ranges::any_of(surface.corners, is_outside)) ++counts_.across_sides;
    counts_.enclosed += enclosed_volume(surface) / std::pow(side_, 3);
    counts_.fraction += volume / std::pow(side_, 3);
  }

  SurfaceCounts finish() {
    file_.commit();
    counts_.triangles = file_.triangles();
    return counts_;
  }

 private:
  double side_;
  bool is_periodic_;
  StlFile file_;
  SurfaceCounts counts_;
};

void add_ellipsoids(const fs::path& directory, const StageEntry& stage, const SurfaceSettings& settings,
                    SurfaceWriter& writer) {
  const auto unit_ball = divided_icosahedron(settings.longest_edge);
  const auto [particles, fillers] = read_stored_ellipsoids(directory, stage);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const auto& material = material_of(stage, fillers[i], directory);
    if (!settings.material.empty() && material != settings.material) continue;
    writer.add(surface_of(particles[i], unit_ball), volume(particles[i]));
  }
}

void add_grains(const fs::path& directory, const StageEntry& stage, SurfaceWriter& writer) {
  const Tessellation<3> tessellation(read_stored_sites<3>(directory, stage));
  for (std::size_t site = 0; site < tessellation.size(); ++site) {
    const auto grain = tessellation.grain(site, *stage.microstructure.film);
    if (grain.is_empty()) continue;
    writer.add(surface_of(grain, tessellation.sites().sites[site].position), volume(grain));
  }
}

std::vector<std::string> materials_of_fillers(const StageEntry& stage) {
  std::vector<std::string> names;
  for (const auto& filler : stage.fillers) {
    if (std::ranges::find(names, filler.material) == names.end()) names.push_back(filler.material);
  }
  return names;
}

}  // namespace

void require_surfaces(const StageEntry& stage, const SurfaceSettings& settings) {
  const auto& name = stage.name;
  if (stage.microstructure.pixels) {
    throw InputError(
        fmt::format("stl: stage {0} is an image, whose particles have no surfaces; {0}/labels.npy and {0}/labels.vti "
                    "have the phases of its points",
                    name));
  }
  if (stage.fillers.empty()) throw InputError(fmt::format("stl: stage {} has no particles", name));
  if (stage.dimensions == 2) {
    const auto* const instead = stage.microstructure.film
                                    ? "msh has the mesh of its grains and films in the plane"
                                    : "its particles are listed in microstructure.csv and polygons.csv, and labels.vti "
                                      "has the phases of its points";
    throw InputError(
        fmt::format("stl: stage {} is in the plane, and the format has surfaces in space; {}", name, instead));
  }
  const auto materials = materials_of_fillers(stage);
  if (!settings.material.empty() && std::ranges::find(materials, settings.material) == materials.end()) {
    throw InputError(fmt::format("stage {} has no particles of \"{}\"{}", name, settings.material,
                                 suggestion(settings.material, materials)));
  }
}

SurfaceCounts write_surfaces(const fs::path& file, const fs::path& directory, const StageEntry& stage,
                             const SurfaceSettings& settings) {
  require_surfaces(stage, settings);
  SurfaceWriter writer(file, stage, settings.unit);
  if (stage.microstructure.film) {
    add_grains(directory, stage, writer);
  } else {
    add_ellipsoids(directory, stage, settings, writer);
  }
  return writer.finish();
}

}  // namespace breccia
