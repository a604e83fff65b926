#include "breccia/results/stage_picture.hpp"

#include <array>
#include <cstddef>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/homogenisation/middle_plane.hpp"
#include "breccia/homogenisation/stage_discretisation.hpp"
#include "breccia/microstructure/tessellation.hpp"
#include "breccia/report/grain_picture.hpp"
#include "breccia/report/image_picture.hpp"
#include "breccia/report/particle_picture.hpp"

namespace breccia {
namespace {

/// The fillers of a stage in the colours of their phases.
std::vector<DrawnFiller> drawn_fillers(const Stage& stage) {
  const auto phases = phases_of(stage);
  std::vector<DrawnFiller> drawn;
  for (const auto& filler : stage.fillers) {
    auto& one = drawn.emplace_back(DrawnFiller{phases.index_of(phase_of(stage, filler.material))});
    if (!filler.coating) continue;
    one.coating_colour = phases.index_of(phase_of(stage, filler.coating->material));
    one.coating_thickness = filler.coating->thickness;
  }
  return drawn;
}

std::string picture_of(const Stage& stage, const LabelImage<2>& image) {
  const auto phases = phases_of(stage);
  std::vector<std::size_t> colours = {0};
  for (const auto& filler : stage.fillers) colours.push_back(phases.index_of(phase_of(stage, filler.material)));
  return image_picture(image, colours);
}

/// What a plane cuts through where it is drawn by what is at its places.
std::string content_of(const Stage& stage, const StageMicrostructure& packed) {
  if (const auto* stack = stage.stack()) return fmt::format("{} voxels", fmt::join(stack->pixels, " x "));
  if (packed.grains) return fmt::format("{} grains", packed.grains->cell_count());
  return fmt::format("{} particles", packed.particles());
}

std::string cut_of(const Stage& stage, const StageMicrostructure& packed, Axis normal) {
  if (packed.spheres) return cut_picture(*packed.spheres, normal, drawn_fillers(stage));
  constexpr std::array names = {"x", "y", "z"};
  const auto axis = static_cast<std::size_t>(normal);
  return plane_picture(middle_plane(stage, packed, axis), fmt::format("cut through the middle of {}, seen along {}",
                                                                      content_of(stage, packed), names[axis]));
}

}  // namespace

std::string stage_picture(const Stage& stage, const StageMicrostructure& microstructure, Axis normal) {
  if (stage.dimensions == 3) return cut_of(stage, microstructure, normal);
  if (const auto* image = stage.image()) return picture_of(stage, *image);
  if (const auto& grains = microstructure.grains) {
    return grain_picture(Tessellation<2>(grains->sites), grains->film);
  }
  if (microstructure.shaped) return particle_picture(*microstructure.shaped, drawn_fillers(stage));
  return microstructure_picture(microstructure.microstructure, drawn_fillers(stage));
}

}  // namespace breccia
