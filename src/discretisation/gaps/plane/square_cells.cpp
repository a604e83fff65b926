#include "discretisation/gaps/plane/square_cells.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "discretisation/gaps/plane/cell_shares.hpp"
#include "discretisation/gaps/plane/cell_terms.hpp"
#include "microstructure/shapes/particle_validity.hpp"

namespace breccia::gaps {
namespace {

/// The middle of a gap on a face.
Vector<2> middle_of(const CellPlace& place, int face) {
  return place.face_place(face).line().at(place.face(face).split);
}

/// Throws InputError unless each particle has phases, and none overlaps another one with its coating.
void require_valid(const ParticlesInBox<2>& particles) {
  if (particles.phases.size() != particles.box.particles.size()) {
    throw InputError(fmt::format("gaps under a cell: expected a phase for each of {} particles, got {}",
                                 particles.box.particles.size(), particles.phases.size()));
  }
  auto box = particles.box;
  box.coatings.clear();
  for (const auto& phases : particles.phases) box.coatings.push_back(phases.coating_thickness);
  breccia::require_valid(box);
}

/// The gap cell at a cell of the grid; nothing for a cell of one phase whose faces have no unknowns.
std::optional<GapCell<2>> make_gap_cell(const GapGeometry<2>& geometry, const Index<2>& at) {
  const CellPlace place(geometry, at);
  GapCell<2> cell;
  for (int face = 0; face < faces_of_cell<2>; ++face) {
    std::ranges::copy(geometry.faces.unknowns(place.face_place(face)),
                      cell.gap_unknowns.begin() + unknowns_of_face * face);
  }
  SharesOutsideChannels found;
  tie_slopes(geometry, place, cell.terms);
  if (place.is_in_chain()) {
    const auto ends = ends_of_channel(place);
    const auto channel = make_channel(geometry.images, place.owner(0), place.second_owner(),
                                      middle_of(place, ends.begin), middle_of(place, ends.end));
    found.shares = shares_of_channel(geometry, place, channel);
    add_flow_along(geometry, place, channel, cell.terms);
    add_corner_of_particle(geometry, place, cell.terms);
  } else {
    found = shares_of_cell(geometry, place);
    add_flow(geometry, place, cell.terms);
  }
  const auto has_none = std::ranges::all_of(cell.gap_unknowns, [](auto number) { return number == GapCell<2>::none; });
  if (has_none && found.is_one_phase) return std::nullopt;
  cell.mixture = std::move(found.shares.mixture);
  cell.shares = std::move(found.shares.shares);
  cell.volume = volume_change(place);
  return cell;
}

}  // namespace

GapCells<2> find_gap_cells(const ParticlesInBox<2>& particles, int cells, Boundary boundary) {
  require_valid(particles);
  const ParticleImages<2> images(particles, cells, boundary);
  const Owners<2> owners(images);
  const FaceTable faces(images, owners);
  const Grid<2> grid = {{cells, cells}, particles.box.side / cells};
  const GapGeometry<2> geometry = {images, owners, faces, particles.matrix, particles.phases};
  return collect_gap_cells(grid, faces.nodes(), faces.first_unknowns(),
                           [&](const Index<2>& cell) { return make_gap_cell(geometry, cell); });
}

}  // namespace breccia::gaps
