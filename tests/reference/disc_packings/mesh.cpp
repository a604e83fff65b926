#include "mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

namespace disc_packings {
namespace {

using Eigen::Vector2d;

/// An edge of which both cells make elements or, on a wall, the only one.
struct SharedEdge {
  int number;
  std::vector<Vector2d> points;  ///< in the order of the cell that owns the edge
};

/// Of the two cells at an edge, this one owns it.
bool owns_edge(int disc, const Image& beyond) {
  if (beyond.is_mirrored) return true;
  if (disc != beyond.disc) return disc < beyond.disc;
  return beyond.boxes_x > 0 || (beyond.boxes_x == 0 && beyond.boxes_y > 0);
}

/// The image of the own disc that the cell beyond an edge sees.
Image seen_from_beyond(int disc, const Image& beyond) {
  return {disc, -beyond.boxes_x, -beyond.boxes_y};
}

using EdgeKey = std::array<int, 4>;

EdgeKey key_of_edge(int owner, const Image& beyond) {
  return {owner, beyond.disc, beyond.boxes_x, beyond.boxes_y};
}

/// The elements of a packing, made cell by cell. In every cell they form rows from the disc outwards, numbered by
/// nodes: row 0 is on the circle, the last row is the edge, negative rows are within the disc.
class MeshMaker {
 public:
  MeshMaker(const Packing& packing, Box box, Filler filler, const MeshSize& size)
      : packing_(packing), size_(size), cells_(laguerre_cells(packing, box)), last_row_(size.order * size.layers) {
    divide_edges();
    if (filler == Filler::deformable) divide_radii();
  }

  Mesh make() && {
    for (int disc = 0; disc < static_cast<int>(cells_.size()); ++disc) {
      for (int side = 0; side < cells_[disc].sides(); ++side) {
        if (!cells_[disc].is_collapsed(side)) add_elements(disc, side);
      }
    }
    return std::move(mesh_);
  }

 private:
  /// What one side of a cell and its disc enclose, with columns of nodes from corner to corner.
  struct Sector {
    int disc, side;
    int edge;                ///< number of the edge
    int begin_ray, end_ray;  ///< the rays to both corners, by the first corner on each
    bool is_owner;           ///< does the cell own the edge?
    bool is_at_wall;         ///< is the edge on a wall?
    std::vector<Vector2d> edge_points;
    [[nodiscard]] int last_column() const { return static_cast<int>(edge_points.size()) - 1; }
  };

  void divide_edges() {
    for (int disc = 0; disc < static_cast<int>(cells_.size()); ++disc) {
      const LaguerreCell& cell = cells_[disc];
      for (int side = 0; side < cell.sides(); ++side) {
        const Image& beyond = cell.beyond[side];
        if (cell.is_collapsed(side) || !owns_edge(disc, beyond)) continue;
        Edge edge = {cell.corners[side], cell.end_of_side(side), packing_[disc], beyond.of(packing_), {}};
        for (const Image& near : cell.beyond) edge.near.push_back(near.of(packing_));
        for (const Image& near : cells_[beyond.disc].beyond) {
          edge.near.push_back(beyond.move(near.of(packing_)));
        }
        least_gap_ = std::min(least_gap_, gap(edge.one, edge.other));
        const int number = static_cast<int>(edges_.size());
        edges_[key_of_edge(disc, beyond)] = {number, edge_points(edge, size_)};
      }
    }
  }

  /// Layers within the discs, as shares of their radii: at the surface as thin as the elements in the narrowest neck
  /// are long, then thicker by a constant ratio.
  void divide_radii() {
    constexpr double growth = 1.7;
    const auto [smallest, largest] = std::ranges::minmax_element(packing_, {}, &Disc::radius);
    double thickness = std::min(0.25, size_.length * std::sqrt(least_gap_ * smallest->radius) / largest->radius);
    std::vector<double> depths = {0.0};
    while (depths.back() + 1.5 * thickness < 1.0) {
      depths.push_back(depths.back() + thickness);
      thickness = std::min(thickness * growth, size_.length);
    }
    depths.push_back(1.0);
    inner_radii_.clear();
    for (std::size_t layer = 0; layer + 1 < depths.size(); ++layer) {
      const double step = (depths[layer + 1] - depths[layer]) / size_.order;
      for (int node = 0; node < size_.order; ++node) inner_radii_.push_back(1.0 - depths[layer] - step * node);
    }
    inner_radii_.push_back(0.0);
  }

  [[nodiscard]] int first_row() const { return 1 - static_cast<int>(inner_radii_.size()); }

  [[nodiscard]] Sector sector(int disc, int side) const {
    const LaguerreCell& cell = cells_[disc];
    const Image& beyond = cell.beyond[side];
    const int next = (side + 1) % cell.sides();
    const bool is_owner = owns_edge(disc, beyond);
    const Image own = seen_from_beyond(disc, beyond);
    const auto& [number, points] = edges_.at(is_owner ? key_of_edge(disc, beyond) : key_of_edge(beyond.disc, own));
    Sector sector = {.disc = disc,
                     .side = side,
                     .edge = number,
                     .begin_ray = cell.first_corner_at(side),
                     .end_ray = cell.first_corner_at(next),
                     .is_owner = is_owner,
                     .is_at_wall = beyond.is_mirrored,
                     .edge_points = points};
    if (!is_owner) {
      for (Vector2d& point : sector.edge_points) point = beyond.move(point);
      std::ranges::reverse(sector.edge_points);
    }
    if ((sector.edge_points.front() - cell.corners[side]).norm() > 1e-10 ||
        (sector.edge_points.back() - cell.corners[next]).norm() > 1e-10) {
      throw std::runtime_error("the ends of an edge are not the corners of both its cells");
    }
    return sector;
  }

  void add_elements(int disc, int side) {
    const Sector in = sector(disc, side);
    const int order = size_.order;
    for (int column = 0; column < in.last_column(); column += order) {
      for (int row = first_row(); row < last_row_; row += order) {
        MeshElement element = {row < 0 ? Region::disc : Region::binder, disc, {}, {}};
        for (int up = 0; up <= order; ++up) {
          for (int back = order; back >= 0; --back) {
            element.nodes.push_back(node(in, column + back, row + up));
            element.points.push_back(place(in, column + back, row + up));
          }
        }
        mesh_.elements.push_back(std::move(element));
      }
    }
  }

  [[nodiscard]] Vector2d place(const Sector& in, int column, int row) const {
    const auto [centre, radius] = packing_[in.disc];
    const Vector2d to_edge = in.edge_points[column] - centre;
    const double reach = to_edge.norm();
    if (reach <= radius) throw std::runtime_error("an edge is within a disc");
    const double distance = row < 0 ? radius * inner_radii_[-row] : radius + (reach - radius) * row / last_row_;
    return centre + to_edge.normalized() * distance;
  }

  /// What tells a node from all others: where it is, and numbers there.
  enum Place { at_vertex, on_edge, on_ray, in_sector, at_centre };
  using NodeKey = std::array<int, 5>;

  [[nodiscard]] NodeKey key_of_node(const Sector& in, int column, int row) const {
    const bool is_first = column == 0;
    const bool is_last = column == in.last_column();
    if (row == last_row_) {
      const LaguerreCell& cell = cells_[in.disc];
      if (is_first) return {at_vertex, cell.vertices[in.side]};
      if (is_last) return {at_vertex, cell.vertices[(in.side + 1) % cell.sides()]};
      return {on_edge, in.edge, in.is_owner ? column : in.last_column() - column};
    }
    if (row < 0 && row == first_row()) return {at_centre, in.disc};
    if (is_first) return {on_ray, in.disc, in.begin_ray, row};
    if (is_last) return {on_ray, in.disc, in.end_ray, row};
    return {in_sector, in.disc, in.side, column, row};
  }

  int node(const Sector& in, int column, int row) {
    const int next = static_cast<int>(numbers_.size());
    const auto [entry, is_new] = numbers_.insert({key_of_node(in, column, row), next});
    if (is_new) {
      mesh_.disc_of_arc.push_back(row == 0 ? in.disc : -1);
      mesh_.is_on_wall.push_back(false);
    }
    if (in.is_at_wall && row == last_row_) mesh_.is_on_wall[entry->second] = true;
    return entry->second;
  }

  const Packing& packing_;
  MeshSize size_;
  std::vector<LaguerreCell> cells_;
  int last_row_;
  std::vector<double> inner_radii_ = {1.0};  ///< of rows 0, -1, ...
  double least_gap_ = 1.0;
  std::map<EdgeKey, SharedEdge> edges_;
  std::map<NodeKey, int> numbers_;
  Mesh mesh_;
};

}  // namespace

Mesh make_mesh(const Packing& packing, Box box, Filler filler, const MeshSize& size) {
  return MeshMaker(packing, box, filler, size).make();
}

}  // namespace disc_packings
