#include "discretisation/gaps/space/cube_cells.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/microstructure/validity.hpp"

#include "discretisation/gaps/space/cube_shares.hpp"
#include "discretisation/gaps/space/cube_terms.hpp"

namespace breccia::gaps {
namespace {

/// Throws InputError unless each sphere has phases, and none overlaps another one with its coating.
void require_valid(const ParticlesInBox<3>& particles, Boundary boundary) {
  if (boundary != Boundary::periodic) {
    throw InputError("gaps under a cell: expected a periodic boundary in three dimensions");
  }
  if (particles.phases.size() != particles.box.particles.size()) {
    throw InputError(fmt::format("gaps under a cell: expected a phase for each of {} particles, got {}",
                                 particles.box.particles.size(), particles.phases.size()));
  }
  auto box = particles.box;
  for (std::size_t sphere = 0; sphere < box.particles.size(); ++sphere) {
    const double thickness = particles.phases[sphere].coating_thickness;
    if (!(thickness >= 0.0)) {
      throw InputError(
          fmt::format("gaps under a cell: expected coatings of a thickness of 0 or more, got {}", thickness));
    }
    box.particles[sphere].diameter += 2.0 * thickness;
  }
  breccia::require_valid(box);
}

/// Sets the numbers of the unknowns of a cell. Returns whether it has any.
bool set_gap_unknowns(const CubeFaces& faces, const CubePlace& place, GapCell<3>& cell) {
  const auto set = [&](int unknown, std::int32_t number) {
    cell.gap_unknowns[static_cast<std::size_t>(unknown - CellShape<3>::dofs)] = number;
  };
  for (int face = 0; face < faces_of_cell<3>; ++face) set(flow_through_cube(face), faces.flow(place.face_place(face)));
  for (int node = 0; node < CellShape<3>::nodes; ++node) {
    for (const auto& slope : slopes_of_node) set(slope_at(node, slope), faces.slope(place.node(node), slope));
  }
  return std::ranges::any_of(cell.gap_unknowns, [](auto number) { return number != GapCell<3>::none; });
}

/// Whether a particle fills a cell.
bool is_filled_by_one(const GapGeometry<3>& geometry, const CubePlace& place) {
  constexpr double all = 1.0 - 1e-9;
  return place.owners().size() == 1 && geometry.images.content(place.owners().front(), place.corner()) > all;
}

/// The gap cell at a cell of the grid; nothing for a cell far from gaps.
std::optional<GapCell<3>> make_gap_cell(const GapGeometry<3>& geometry, const Index<3>& at) {
  const CubePlace place(geometry, at);
  GapCell<3> cell;
  const bool has_unknowns = set_gap_unknowns(geometry.faces, place, cell);
  if (!has_unknowns && place.has_free_node()) return std::nullopt;
  if (!has_unknowns && is_filled_by_one(geometry, place)) return std::nullopt;
  const auto facet = facet_of(geometry, place);
  auto shares = shares_of_cell(geometry, place, facet);
  tie_slopes(geometry, place, cell.terms);
  add_flow(geometry, place, facet, cell.terms);
  cell.mixture = std::move(shares.mixture);
  cell.shares = std::move(shares.shares);
  cell.volume = volume_change(place);
  return cell;
}

}  // namespace

GapCells<3> find_gap_cells(const ParticlesInBox<3>& particles, int cells, Boundary boundary) {
  require_valid(particles, boundary);
  const ParticleImages<3> images(particles, cells, boundary);
  const Owners<3> owners(images);
  const CubeFaces faces(images, owners);
  const Grid<3> grid = {{cells, cells, cells}, particles.box.side / cells};
  const GapGeometry<3> geometry = {images, owners, faces, particles.matrix, particles.phases};
  return collect_gap_cells(grid, faces.nodes(), faces.first_unknowns(),
                           [&](const Index<3>& cell) { return make_gap_cell(geometry, cell); });
}

}  // namespace breccia::gaps
