#include "results/stage_picture.hpp"

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/homogenisation/stage_discretisation.hpp"
#include "breccia/microstructure/tessellation.hpp"

#include "homogenisation/box/debonded_films.hpp"
#include "homogenisation/box/middle_plane.hpp"
#include "homogenisation/debonding_words.hpp"
#include "report/grain_picture.hpp"
#include "report/image_picture.hpp"
#include "report/particle_picture.hpp"
#include "report/picture_frame.hpp"

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

/// The colours of the phases of a stage in a plane, and that of debonded films.
std::vector<std::string_view> colours_in_plane(const Stage& stage) {
  std::vector<std::string_view> colours = {matrix_colour};
  while (colours.size() < phases_of(stage).size()) colours.push_back(colour_of_phase(colours.size()));
  colours.push_back(debonded_colour);
  return colours;
}

/// The picture of a box: a visitor of its content. For a cube it shows the plane through its middle with this normal.
struct PictureOf {
  const Stage& stage;
  Axis normal;

  std::string operator()(const Microstructure<2>& discs) const {
    return microstructure_picture(discs, drawn_fillers(stage));
  }
  std::string operator()(const ParticleBox& particles) const {
    return particle_picture(particles, drawn_fillers(stage));
  }
  std::string operator()(const Grains<2>& grains) const {
    const Tessellation<2> tessellation(grains.sites);
    const auto state = stage.bonds ? state_of(stage.bonds->kind) : "";
    return grain_picture(tessellation, grains.statistics.film, debonded_films(stage, tessellation).faces, state);
  }
  std::string operator()(const SharedImage<2>& image) const {
    const auto phases = phases_of(stage);
    std::vector<std::size_t> colours = {0};
    for (const auto& filler : stage.fillers) colours.push_back(phases.index_of(phase_of(stage, filler.material)));
    return image_picture(*image, colours);
  }
  std::string operator()(const Microstructure<3>& spheres) const {
    return cut_picture(spheres, normal, drawn_fillers(stage));
  }
  std::string operator()(const EllipsoidBox& ellipsoids) const {
    return cut(ellipsoids, fmt::format("{} particles", ellipsoids.particles.size()));
  }
  std::string operator()(const Grains<3>& grains) const {
    return cut(grains,
               fmt::format("{} grains{}", grains.statistics.cell_count,
                           stage.bonds ? fmt::format(", films that are {} in red", state_of(stage.bonds->kind)) : ""));
  }
  std::string operator()(const SharedImage<3>& image) const {
    return cut(image, fmt::format("{} voxels", fmt::join(image->pixels, " x ")));
  }

 private:
  template <class Content>
  [[nodiscard]] std::string cut(const Content& content, const std::string& in_words) const {
    constexpr std::array names = {"x", "y", "z"};
    const auto axis = static_cast<std::size_t>(normal);
    return plane_picture(middle_plane(stage, content, axis), colours_in_plane(stage),
                         fmt::format("cut through the middle of {}, seen along {}", in_words, names[axis]));
  }
};

}  // namespace

std::string stage_picture(const Stage& stage, const StageMicrostructure& microstructure, Axis normal) {
  return visit_nested(PictureOf{stage, normal}, microstructure.box);
}

}  // namespace breccia
