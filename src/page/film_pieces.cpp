#include "page/film_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia {
namespace {

using Point = std::array<double, 3>;

Point difference(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

using Triangle = std::array<std::size_t, 3>;

/// Three corners of each side of a tetrahedron (four corners) or a wedge (six).
std::span<const Triangle> sides_of(std::size_t corners) {
  static constexpr std::array<Triangle, 4> of_tetrahedron = {{{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  static constexpr std::array<Triangle, 5> of_wedge = {{{0, 1, 2}, {3, 4, 5}, {0, 1, 3}, {1, 2, 4}, {2, 0, 5}}};
  if (corners == 4) return of_tetrahedron;
  return of_wedge;
}

double volume_of_tetrahedron(const Point& a, const Point& b, const Point& c, const Point& d) {
  return std::abs(dot(cross(difference(b, a), difference(c, a)), difference(d, a))) / 6.0;
}

/// A convex piece as the intersection of half spaces.
class Piece {
 public:
  explicit Piece(std::vector<Point> corners) : corners_(std::move(corners)) {
    Point middle{};
    for (const auto& corner : corners_) {
      for (std::size_t i = 0; i < 3; ++i) middle[i] += corner[i] / static_cast<double>(corners_.size());
    }
    for (const auto& [a, b, c] : sides_of(corners_.size())) {
      auto normal = cross(difference(corners_[b], corners_[a]), difference(corners_[c], corners_[a]));
      const double length = std::sqrt(dot(normal, normal));
      if (length == 0.0) continue;
      const double sign = dot(normal, difference(middle, corners_[a])) > 0.0 ? -1.0 : 1.0;
      for (double& component : normal) component *= sign / length;
      planes_.push_back({normal, dot(normal, corners_[a])});
    }
  }

  /// Whether a point is inside the piece, or outside by no more than a distance.
  [[nodiscard]] bool contains(const Point& point, double distance) const {
    return std::ranges::all_of(planes_,
                               [&](const Plane& plane) { return dot(plane.normal, point) <= plane.offset + distance; });
  }

  /// The lowest and the highest coordinate of the corners along an axis.
  [[nodiscard]] std::pair<double, double> range(std::size_t axis) const {
    const auto along = [axis](const Point& point) { return point[axis]; };
    const auto [lowest, highest] = std::ranges::minmax(corners_, {}, along);
    return {lowest[axis], highest[axis]};
  }

 private:
  struct Plane {
    Point normal;
    double offset;
  };
  std::vector<Point> corners_;
  std::vector<Plane> planes_;
};

std::vector<Point> corners_of(const FilmPieces& pieces, std::size_t piece) {
  std::vector<Point> corners;
  for (auto i = pieces.offsets[piece]; i < pieces.offsets[piece + 1]; ++i) {
    corners.push_back(pieces.points[static_cast<std::size_t>(pieces.corners[static_cast<std::size_t>(i)])]);
  }
  return corners;
}

/// Whether pieces have four or six corners each, among the points, and known parts.
bool is_sound(const FilmPieces& pieces) {
  if (pieces.count() == 0 || pieces.offsets.size() != pieces.count() + 1) return false;
  if (pieces.offsets.front() != 0 || pieces.offsets.back() != static_cast<std::int64_t>(pieces.corners.size()))
    return false;
  for (std::size_t i = 0; i < pieces.count(); ++i) {
    const auto corners = pieces.offsets[i + 1] - pieces.offsets[i];
    if (corners != 4 && corners != 6) return false;
    if (pieces.parts[i] < FilmPart::grain || pieces.parts[i] > FilmPart::spring) return false;
  }
  const auto points = static_cast<std::int64_t>(pieces.points.size());
  return std::ranges::all_of(pieces.corners, [points](auto corner) { return corner >= 0 && corner < points; });
}

/// A periodic cube of cells that are filled with the numbers of pieces.
class CellsOfCube {
 public:
  CellsOfCube(double side, std::size_t along, std::size_t nothing)
      : along_(static_cast<std::int64_t>(along)),
        spacing_(side / static_cast<double>(along)),
        cells_(along * along * along, nothing) {}

  /// Puts a piece into the cells whose middles are inside, or outside by no more than a share of a cell.
  void put(std::size_t number, const Piece& piece, double share) {
    const double distance = share * spacing_;
    std::array<std::int64_t, 3> first{}, last{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto [lowest, highest] = piece.range(axis);
      first[axis] = std::llround(std::ceil((lowest - distance) / spacing_ - 0.5));
      last[axis] = std::llround(std::floor((highest + distance) / spacing_ - 0.5));
    }
    for (auto z = first[2]; z <= last[2]; ++z) {
      for (auto y = first[1]; y <= last[1]; ++y) {
        for (auto x = first[0]; x <= last[0]; ++x) {
          if (piece.contains({middle(x), middle(y), middle(z)}, distance)) at(x, y, z) = number;
        }
      }
    }
  }

  [[nodiscard]] std::vector<std::size_t> take() { return std::move(cells_); }

 private:
  [[nodiscard]] double middle(std::int64_t index) const { return (static_cast<double>(index) + 0.5) * spacing_; }
  [[nodiscard]] std::int64_t wrapped(std::int64_t index) const { return (index % along_ + along_) % along_; }
  std::size_t& at(std::int64_t x, std::int64_t y, std::int64_t z) {
    return cells_[static_cast<std::size_t>((wrapped(z) * along_ + wrapped(y)) * along_ + wrapped(x))];
  }

  std::int64_t along_;
  double spacing_;
  std::vector<std::size_t> cells_;
};

}  // namespace

FilmPieces film_pieces(const std::string& name, const Hdf5Reader& file) {
  FilmPieces pieces;
  const auto coordinates = file.read_numbers("/VTKHDF/Points");
  for (std::size_t i = 0; i + 2 < coordinates.size(); i += 3) {
    pieces.points.push_back({coordinates[i], coordinates[i + 1], coordinates[i + 2]});
  }
  pieces.corners = file.read_integers("/VTKHDF/Connectivity");
  pieces.offsets = file.read_integers("/VTKHDF/Offsets");
  for (const auto part : file.read_integers("/VTKHDF/CellData/part")) {
    pieces.parts.push_back(static_cast<FilmPart>(part));
  }
  if (!is_sound(pieces)) throw FileError(fmt::format("{}: expected tetrahedra and wedges of grains and films", name));
  return pieces;
}

std::vector<double> volumes_of(const FilmPieces& pieces) {
  std::vector<double> volumes;
  for (std::size_t i = 0; i < pieces.count(); ++i) {
    const auto c = corners_of(pieces, i);
    volumes.push_back(c.size() == 4 ? volume_of_tetrahedron(c[0], c[1], c[2], c[3])
                                    : volume_of_tetrahedron(c[0], c[1], c[2], c[5]) +
                                          volume_of_tetrahedron(c[0], c[1], c[4], c[5]) +
                                          volume_of_tetrahedron(c[0], c[3], c[4], c[5]));
  }
  return volumes;
}

std::vector<std::size_t> pieces_in_cells(const FilmPieces& pieces, double side, std::size_t along) {
  constexpr double of_grains = 1e-6, of_binder = 0.5;
  CellsOfCube cells(side, along, pieces.count());
  const auto put = [&](bool is_grain, double share) {
    for (std::size_t i = 0; i < pieces.count(); ++i) {
      if ((pieces.parts[i] == FilmPart::grain) != is_grain) continue;
      cells.put(i, Piece(corners_of(pieces, i)), share);
    }
  };
  put(true, of_grains);
  put(false, of_binder);
  return cells.take();
}

}  // namespace breccia
