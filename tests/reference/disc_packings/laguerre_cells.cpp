#include "laguerre_cells.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace disc_packings {
namespace {

using Eigen::Vector2d;

constexpr double same_point = 1e-10;  // corners that are nearer are one vertex
constexpr double short_edge = 1e-3;   // edges that are shorter, as a share of the distance from the disc, are collapsed

/// Are two corners of a cell, which were moved to their vertices, at the same one?
bool are_joined(const Vector2d& one, const Vector2d& other) {
  return (one - other).norm() < 1e-11;
}

/// What is nearer to a disc than to another one: direction . (x - centre) <= distance.
struct HalfPlane {
  Vector2d direction;
  double distance;
  Image other;
};

/// The half-planes that can bound the cell of a disc, the nearest first.
std::vector<HalfPlane> half_planes(const Packing& packing, Box box, int disc) {
  const int most_boxes = box == Box::periodic ? 2 : 0;
  const Disc& own = packing[disc];
  std::vector<HalfPlane> planes;
  for (int other = 0; other < static_cast<int>(packing.size()); ++other) {
    for (int boxes_x = -most_boxes; boxes_x <= most_boxes; ++boxes_x) {
      for (int boxes_y = -most_boxes; boxes_y <= most_boxes; ++boxes_y) {
        if (other == disc && boxes_x == 0 && boxes_y == 0) continue;
        const Image image = {other, boxes_x, boxes_y};
        const Disc neighbour = image.of(packing);
        const Vector2d distance = neighbour.centre - own.centre;
        // Images of its own disc keep a cell within half the diagonal of the box, sqrt(1/2), of the centre; a disc that
        // is farther than this, and of a radius of at most 1/2, cannot cut it. Within walls no discs are so far apart.
        if (distance.norm() > 1.6) continue;
        if (gap(own, neighbour) <= 0.0) throw std::runtime_error("discs overlap");
        const double power = own.radius * own.radius - neighbour.radius * neighbour.radius;
        planes.push_back({distance.normalized(), (distance.squaredNorm() + power) / (2.0 * distance.norm()), image});
      }
    }
  }
  std::ranges::sort(planes, {}, &HalfPlane::distance);
  return planes;
}

/// Cuts off what is outside of a half-plane; the corners are relative to the centre of the disc.
void cut(LaguerreCell& cell, const HalfPlane& plane) {
  LaguerreCell rest;
  const auto add = [&](const Vector2d& corner, const Image& beyond) {
    rest.corners.push_back(corner);
    rest.beyond.push_back(beyond);
  };
  for (int side = 0; side < cell.sides(); ++side) {
    const Vector2d& begin = cell.corners[side];
    const Vector2d& end = cell.end_of_side(side);
    const double height_of_begin = plane.direction.dot(begin) - plane.distance;
    const double height_of_end = plane.direction.dot(end) - plane.distance;
    const auto crossing = [&] {
      return Vector2d(begin + (end - begin) * (height_of_begin / (height_of_begin - height_of_end)));
    };
    if (height_of_begin <= 0.0) {
      add(begin, cell.beyond[side]);
      if (height_of_end > 0.0) add(crossing(), plane.other);
    } else if (height_of_end <= 0.0) {
      add(crossing(), cell.beyond[side]);
    }
  }
  cell = rest;
}

/// A square around the largest cell of a periodic box, with nothing beyond.
LaguerreCell large_square() {
  constexpr Image nothing = {-1, 0, 0};
  return {{{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}, std::vector<Image>(4, nothing), {}};
}

/// The walls as seen from a disc, its mirror images beyond.
LaguerreCell walls_around(const Packing& packing, int disc) {
  const Disc& own = packing[disc];
  LaguerreCell walls = {{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}},
                        {{disc, 0, -1, true}, {disc, 1, 0, true}, {disc, 0, 1, true}, {disc, -1, 0, true}},
                        {}};
  for (const Image& beyond : walls.beyond) {
    if (gap(own, beyond.of(packing)) <= 0.0) throw std::runtime_error("a disc overlaps a wall");
  }
  if ((own.centre - Vector2d(0.5, 0.5)).lpNorm<Eigen::Infinity>() >= 0.5) {
    throw std::runtime_error("a disc is outside of the walls");
  }
  for (Vector2d& corner : walls.corners) corner -= own.centre;
  return walls;
}

LaguerreCell cell_of(const Packing& packing, Box box, int disc) {
  LaguerreCell cell = box == Box::periodic ? large_square() : walls_around(packing, disc);
  for (const HalfPlane& plane : half_planes(packing, box, disc)) {
    double reach = 0.0;
    for (const Vector2d& corner : cell.corners) reach = std::max(reach, corner.norm());
    if (plane.distance > reach) break;
    cut(cell, plane);
  }
  for (const Image& beyond : cell.beyond) {
    if (beyond.disc < 0) throw std::runtime_error("a cell is not bounded by its neighbours");
  }
  for (Vector2d& corner : cell.corners) corner += packing[disc].centre;
  return cell;
}

/// How many boxes two points are apart, if they are images of each other.
Vector2d whole_boxes(Box box, const Vector2d& distance) {
  if (box == Box::walled) return Vector2d::Zero();
  return {std::round(distance.x()), std::round(distance.y())};
}

Vector2d shortest_image(Box box, const Vector2d& distance) {
  return distance - whole_boxes(box, distance);
}

/// Sets of corners that become one vertex.
class CornerSets {
 public:
  explicit CornerSets(int corners) : parents_(corners) { std::iota(parents_.begin(), parents_.end(), 0); }

  int set_of(int corner) {
    while (parents_[corner] != corner) corner = parents_[corner] = parents_[parents_[corner]];
    return corner;
  }
  void join(int one, int other) { parents_[set_of(one)] = set_of(other); }

 private:
  std::vector<int> parents_;
};

/// Moves the mean of some corners to the walls that one of them is on.
void move_to_walls(Vector2d& mean, const Vector2d& corner) {
  for (int axis = 0; axis < 2; ++axis) {
    for (const double wall : {0.0, 1.0}) {
      if (std::abs(corner[axis] - wall) < same_point) mean[axis] = wall;
    }
  }
}

/// Moves all corners of a set to images of their mean, on a wall if one of them is, and numbers the vertices.
void move_to_vertices(Box box, std::vector<LaguerreCell>& cells, const std::vector<Vector2d*>& corners,
                      CornerSets& sets) {
  const int count = static_cast<int>(corners.size());
  std::vector<Vector2d> sums(count, Vector2d::Zero());
  std::vector<int> sizes(count, 0);
  for (int corner = 0; corner < count; ++corner) {
    const int set = sets.set_of(corner);
    sums[set] += shortest_image(box, *corners[corner] - *corners[set]);
    ++sizes[set];
  }
  std::vector<Vector2d> means(count);
  for (int set = 0; set < count; ++set) {
    if (sizes[set] > 0) means[set] = *corners[set] + sums[set] / sizes[set];
  }
  if (box == Box::walled) {
    for (int corner = 0; corner < count; ++corner) move_to_walls(means[sets.set_of(corner)], *corners[corner]);
  }
  for (int corner = 0; corner < count; ++corner) {
    const Vector2d& mean = means[sets.set_of(corner)];
    *corners[corner] = mean + whole_boxes(box, *corners[corner] - mean);
  }
  int corner = 0;
  for (LaguerreCell& cell : cells) {
    for (int side = 0; side < cell.sides(); ++side) cell.vertices.push_back(sets.set_of(corner++));
  }
}

/// Finds the vertices: corners of all cells at one point, and the ends of edges that are too short for elements.
void join_corners(const Packing& packing, Box box, std::vector<LaguerreCell>& cells) {
  std::vector<Vector2d*> corners;
  for (LaguerreCell& cell : cells) {
    for (Vector2d& corner : cell.corners) corners.push_back(&corner);
  }
  CornerSets sets(static_cast<int>(corners.size()));
  for (int one = 0; one < static_cast<int>(corners.size()); ++one) {
    for (int other = one + 1; other < static_cast<int>(corners.size()); ++other) {
      if (shortest_image(box, *corners[one] - *corners[other]).norm() < same_point) sets.join(one, other);
    }
  }
  int first = 0;
  for (std::size_t disc = 0; disc < cells.size(); ++disc) {
    const LaguerreCell& cell = cells[disc];
    const auto [centre, radius] = packing[disc];
    for (int side = 0; side < cell.sides(); ++side) {
      const Vector2d& begin = cell.corners[side];
      const Vector2d& end = cell.end_of_side(side);
      const double clearance = std::min((begin - centre).norm(), (end - centre).norm()) - radius;
      if ((end - begin).norm() < std::max(short_edge * clearance, same_point)) {
        sets.join(first + side, first + (side + 1) % cell.sides());
      }
    }
    first += cell.sides();
  }
  move_to_vertices(box, cells, corners, sets);
}

}  // namespace

Vector2d Image::move(const Vector2d& point) const {
  const Vector2d boxes(boxes_x, boxes_y);
  if (!is_mirrored) return point + boxes;
  const double wall = std::max(boxes.sum(), 0.0);  // boxes . x on the wall
  return point - 2.0 * (boxes.dot(point) - wall) * boxes;
}

const Vector2d& LaguerreCell::end_of_side(int side) const {
  return corners[(side + 1) % corners.size()];
}

bool LaguerreCell::is_collapsed(int side) const {
  return are_joined(corners[side], end_of_side(side));
}

int LaguerreCell::first_corner_at(int corner) const {
  const auto first =
      std::ranges::find_if(corners, [&](const auto& other) { return are_joined(other, corners[corner]); });
  return static_cast<int>(first - corners.begin());
}

std::vector<LaguerreCell> laguerre_cells(const Packing& packing, Box box) {
  std::vector<LaguerreCell> cells;
  for (int disc = 0; disc < static_cast<int>(packing.size()); ++disc) cells.push_back(cell_of(packing, box, disc));
  join_corners(packing, box, cells);
  return cells;
}

}  // namespace disc_packings
