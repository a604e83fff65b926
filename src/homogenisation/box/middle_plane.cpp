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
  const Tessellation<3> tessellation(grains.sites);
  const auto debonded = debonded_films(stage, tessellation).faces;
  const std::set<CellFace<3>> listed(debonded.begin(), debonded.end());
  const auto is_debonded = [&](const LocatedGrain& place) {
    const auto& faces = tessellation.cell(place.site).half_spaces();
    const auto second = Tessellation<3>::neighbour(faces[place.face]);
    if (!second) return false;
    const auto image = Tessellation<3>::image(faces[place.face]);
    return listed.contains({place.site, *second, image}) ||
           listed.contains({*second, place.site, {-image[0], -image[1], -image[2]}});
  };
  const auto of_debonded = static_cast<PhaseIndex>(phases_of(stage).size());
  const GrainLocator<3> locator(tessellation, grains.statistics.film);
  const auto phase_at = labelling_of(stage, grains);
  const Labelling<3> labelling = [&](const Vector<3>& position) -> PhaseAt {
    const auto place = locator.at(position);
    if (place.is_in_grain() || !is_debonded(place)) return phase_at(position);
    return {of_debonded, 0.0};
  };
  return middle_plane(stage, labelling, normal);
}

LabelImage<2> middle_plane(const Stage& stage, const SharedImage<3>& image, std::size_t normal) {
  return middle_plane(stage, labelling_of(stage, image), normal);
}

}  // namespace breccia
