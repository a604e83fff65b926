#include "discretisation/gaps/gap_cells.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "discretisation/gaps/cell_shares.hpp"
#include "discretisation/gaps/cell_terms.hpp"

namespace breccia::gaps {
namespace {

/// The middle of a gap on a face.
Vector<2> middle_of(const CellPlace& place, int face) {
  return place.face_place(face).line().at(place.face(face).split);
}

/// Whether a cell would be the same without gaps: of one phase, whose faces have no unknowns.
bool is_plain(const GapCell& cell) {
  const auto has_none = std::ranges::all_of(cell.face_unknowns, [](auto number) { return number == GapCell::none; });
  return has_none && cell.shares.size() == 1 && (cell.shares.front() == 1.0).all();
}

/// The gap cell at a cell of the grid; nothing for a plain one.
std::optional<GapCell> make_gap_cell(const GapGeometry& geometry, const Index<2>& at) {
  const CellPlace place(geometry, at);
  GapCell cell;
  for (int face = 0; face < faces_of_cell; ++face) {
    std::ranges::copy(geometry.faces.unknowns(place.face_place(face)),
                      cell.face_unknowns.begin() + unknowns_of_face * face);
  }
  CellShares shares;
  tie_slopes(geometry, place, cell.terms);
  if (place.is_in_chain()) {
    const auto ends = ends_of_channel(place);
    const auto channel = make_channel(geometry.discs, place.owner(0), place.second_owner(),
                                      middle_of(place, ends.begin), middle_of(place, ends.end));
    shares = shares_of_channel(geometry, place, channel);
    add_flow_along(geometry, place, channel, cell.terms);
    add_corner_of_particle(geometry, place, cell.terms);
  } else {
    shares = shares_of_cell(geometry, place);
    add_flow(geometry, place, cell.terms);
  }
  cell.mixture = std::move(shares.mixture);
  cell.shares = std::move(shares.shares);
  if (is_plain(cell)) return std::nullopt;
  cell.volume = volume_change(place);
  return cell;
}

}  // namespace

GapCells::GapCells(const Grid<2>& grid, std::vector<GapCell> cells, std::span<const std::size_t> places,
                   std::vector<std::int32_t> first_unknowns)
    : grid_(grid),
      cells_(std::move(cells)),
      numbers_(grid.cell_count(), GapCell::none),
      first_unknowns_(std::move(first_unknowns)) {
  for (std::size_t number = 0; number < places.size(); ++number) {
    numbers_[places[number]] = static_cast<std::int32_t>(number);
  }
}

GapCells find_gap_cells(const Microstructure<2>& microstructure, int cells, PhaseIndex matrix,
                        std::span<const PhaseIndex> particles) {
  if (particles.size() != microstructure.particles.size()) {
    throw InputError(fmt::format("gaps under a cell: expected a phase for each of {} particles, got {}",
                                 microstructure.particles.size(), particles.size()));
  }
  const DiscImages discs(microstructure, cells);
  const Owners owners(discs);
  const FaceTable faces(discs, owners);
  const GapGeometry geometry = {discs, owners, faces, matrix, particles};
  const Grid<2> grid = {{cells, cells}, microstructure.side / cells};
  std::vector<GapCell> gap_cells;
  std::vector<std::size_t> places;
  grid.for_each_cell([&](const Index<2>& cell) {
    auto gap_cell = make_gap_cell(geometry, cell);
    if (!gap_cell) return;
    gap_cells.push_back(std::move(*gap_cell));
    places.push_back(grid.cell_index(cell));
  });
  return {grid, std::move(gap_cells), places, faces.first_unknowns()};
}

}  // namespace breccia::gaps
