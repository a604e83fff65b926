#include "quasistatic/solvers/substructuring/shared_blocks.hpp"

#include <array>
#include <map>
#include <utility>

namespace breccia::quasistatic {
namespace {

/// The grids of the next processes along the axes.
class NextGrids {
 public:
  NextGrids(const BlockDivision& division, int rank, const UnknownsOfFaces& faces)
      : division_(&division), faces_(&faces), position_(division.position_of(rank)) {}

  /// The rank and the grid of the next process along one or both axes.
  std::pair<int, const BlockGrid&> next(bool along_first, bool along_second) {
    const int rank = division_->rank_at({position_[0] + (along_first ? 1 : 0), position_[1] + (along_second ? 1 : 0)});
    return {rank, grids_.try_emplace(rank, *division_, rank, *faces_).first->second};
  }

 private:
  const BlockDivision* division_;
  const UnknownsOfFaces* faces_;
  std::array<int, 2> position_;
  std::map<int, BlockGrid> grids_;
};

}  // namespace

std::vector<int> edges_between_processes(const BlockGrid& grid) {
  std::vector<int> edges;
  const auto add_row = [&](int row) {
    for (int column = 0; column < grid.across(); ++column) edges.push_back(grid.horizontal_edge(column, row));
  };
  const auto add_column = [&](int column) {
    for (int row = 0; row < grid.up(); ++row) edges.push_back(grid.vertical_edge(column, row));
  };
  if (grid.rows().begins_at_neighbour) add_row(0);
  if (grid.columns().begins_at_neighbour) add_column(0);
  if (grid.rows().ends_at_neighbour) add_row(grid.up());
  if (grid.columns().ends_at_neighbour) add_column(grid.across());
  return edges;
}

SharedBoundaries shared_boundaries(const BlockDivision& division, int rank, const UnknownsOfFaces& faces) {
  const BlockGrid grid(division, rank, faces);
  const int across = grid.across(), up = grid.up();
  NextGrids grids(division, rank, faces);
  SharedBoundaries shared;
  const auto add_vertex = [&](int column, int row, bool is_right, bool is_top) {
    const auto [owner, other] = grids.next(is_right, is_top);
    const int vertex = other.vertex(is_right ? 0 : column, is_top ? 0 : row);
    shared.vertices.push_back({grid.vertex(column, row), owner, vertex, other.first_unknown_of_vertex(vertex)});
  };
  if (grid.columns().ends_at_neighbour) {
    const auto [owner, other] = grids.next(true, false);
    for (int row = 0; row < up; ++row) {
      add_vertex(across, row, true, false);
      const int edge = other.vertical_edge(0, row);
      shared.edges.push_back({grid.vertical_edge(across, row), owner, edge, other.first_unknown_of_edge(edge)});
    }
  }
  if (grid.rows().ends_at_neighbour) {
    const auto [owner, other] = grids.next(false, true);
    for (int column = 0; column < across; ++column) {
      add_vertex(column, up, false, true);
      const int edge = other.horizontal_edge(column, 0);
      shared.edges.push_back({grid.horizontal_edge(column, up), owner, edge, other.first_unknown_of_edge(edge)});
    }
  }
  const bool right = grid.columns().ends_at_neighbour, top = grid.rows().ends_at_neighbour;
  const bool has_corner = !grid.columns().wraps && !grid.rows().wraps;
  if (has_corner && (right || top)) add_vertex(across, up, right, top);
  return shared;
}

SharedValues shared_unknowns(const BlockGrid& grid, const SharedBoundaries& shared) {
  std::vector<SharedValues::Copy> copies;
  const auto add = [&](int first, int count, const SharedBoundary& boundary) {
    for (int i = 0; i < count; ++i) copies.push_back({first + i, boundary.owner, boundary.first_unknown_at_owner + i});
  };
  for (const auto& vertex : shared.vertices) add(grid.first_unknown_of_vertex(vertex.number), 2, vertex);
  for (const auto& edge : shared.edges) {
    add(grid.first_unknown_of_edge(edge.number), grid.unknowns_of_edge(edge.number), edge);
  }
  return {grid.unknowns(), copies};
}

SharedValues shared_edges(const BlockDivision& division, int rank, const SharedBoundaries& shared) {
  const auto indices_of = [&](int process) {
    std::map<int, int> indices;
    for (const int edge : edges_between_processes(BlockGrid(division, process))) {
      indices.emplace(edge, static_cast<int>(indices.size()));
    }
    return indices;
  };
  const auto own = indices_of(rank);
  std::map<int, std::map<int, int>> of_owner;
  std::vector<SharedValues::Copy> copies;
  for (const auto& edge : shared.edges) {
    if (!of_owner.contains(edge.owner)) of_owner.emplace(edge.owner, indices_of(edge.owner));
    copies.push_back({own.at(edge.number), edge.owner, of_owner.at(edge.owner).at(edge.number_at_owner)});
  }
  return {static_cast<int>(own.size()), copies};
}

}  // namespace breccia::quasistatic
