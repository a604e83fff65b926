#include "homogenisation/box/middle_plane.hpp"

#include <set>

#include "breccia/homogenisation/stage_discretisation.hpp"
#include "breccia/microstructure/cell_faces.hpp"
#include "breccia/microstructure/tessellation.hpp"

#include "homogenisation/box/debonded_films.hpp"
#include "homogenisation/box/stage_labelling.hpp"
#include "microstructure/tessellation/grain_locator.hpp"

namespace breccia {
namespace {

LabelImage<2> middle_plane(const Stage& stage, const Labelling<3>& labelling, std::size_t normal) {
  constexpr int pixels = 500;
  const std::size_t across = (normal + 1) % 3, up = (normal + 2) % 3;
  LabelImage<2> plane = {.pixels = {pixels, pixels},
                         .pixel_side = stage.side / pixels,
                         .walls = stage.is_periodic() ? Walls::periodic : Walls::hard,
                         .labels = {}};
  Vector<3> place{};
  place[normal] = 0.5 * stage.side;
  for (int row = 0; row < pixels; ++row) {
    place[up] = (row + 0.5) * plane.pixel_side;
    for (int column = 0; column < pixels; ++column) {
      place[across] = (column + 0.5) * plane.pixel_side;
      plane.labels.push_back(labelling(place).phase);
    }
  }
  return plane;
}

}  // namespace

LabelImage<2> middle_plane(const Stage& stage, const EllipsoidBox& ellipsoids, std::size_t normal) {
  return middle_plane(stage, labelling_of(stage, ellipsoids), normal);
}

LabelImage<2> middle_plane(const Stage& stage, const Grains<3>& grains, std::size_t normal) {
  if (!stage.bonds) return middle_plane(stage, labelling_of(stage, grains), normal);
  const Tessellation<3> tessellation(grains.sites);
  const auto debonded = debonded_films(stage, tessellation).faces;
  const std::set<CellFace<3>> listed(debonded.begin(), debonded.end());
  const auto is_debonded = [&](const LocatedGrain& place) {
    const auto& face = tessellation.cell(place.site).half_spaces()[place.face];
    const auto second = Tessellation<3>::neighbour(face);
    if (!second) return false;
    const auto image = Tessellation<3>::image(face);
    return listed.contains({place.site, *second, image}) ||
           listed.contains({*second, place.site, {-image[0], -image[1], -image[2]}});
  };
  const auto phases = phases_of(stage);
  const auto matrix = phases.index_of(name_of_matrix_phase);
  const auto filler = phases.index_of(phase_of(stage, stage.fillers.front().material));
  const auto of_debonded = static_cast<PhaseIndex>(phases.size());
  const GrainLocator<3> locator(tessellation, grains.statistics.film);
  const Labelling<3> labelling = [&](const Vector<3>& position) -> PhaseAt {
    const auto place = locator.at(position);
    if (place.is_in_grain()) return {filler, place.depth};
    return {is_debonded(place) ? of_debonded : matrix, -place.depth};
  };
  return middle_plane(stage, labelling, normal);
}

LabelImage<2> middle_plane(const Stage& stage, const SharedImage<3>& image, std::size_t normal) {
  return middle_plane(stage, labelling_of(stage, image), normal);
}

}  // namespace breccia
