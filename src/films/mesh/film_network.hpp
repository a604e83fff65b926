#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "breccia/microstructure/tessellation.hpp"

#include "films/mesh/grain_polygon.hpp"

namespace breccia::films {

/// A corner of a grain, in an image of the box.
struct CornerImage {
  std::size_t grain;
  std::size_t corner;
  Eigen::Vector2i image;  ///< sides of the box by which the grain is displaced
};

/// A junction of several films: the polygon between the corners of the grains around it, a triangle between three
/// grains. Where a film ends at a wall between two grains it is a line, the end of the film.
struct Junction {
  std::vector<CornerImage> corners;  ///< counter-clockwise; at a wall, the last and the first are those next to it
  bool is_at_wall = false;
};

/// One of the two sides of a film.
struct FilmSide {
  /// Corners of the grain at both ends; one corner twice where the face of this grain has vanished.
  CornerImage begin, end;
  std::optional<std::size_t> face;  ///< the face of the grain along the film, unless it has vanished
};

/// The film between two grains, from one junction to another. Along the first side the grain's face runs from the start
/// to the end; the second side is opposite.
struct Film {
  std::array<FilmSide, 2> sides;
  Eigen::Vector2d direction;  ///< direction from start to end, of length 1
  Eigen::Vector2d normal;     ///< direction from the first side to the second, of length 1
  double thickness;           ///< thickness [sides of the box]; with one face, its distance from the other grain
  std::array<std::size_t, 2> junctions;  ///< junctions at its start and at its end
  int segments;                          ///< number of equal elements along it

  [[nodiscard]] std::array<std::size_t, 2> grains() const { return {sides[0].begin.grain, sides[1].begin.grain}; }
  /// Sides of the box by which the grain on the second side is displaced if that on the first side is not.
  [[nodiscard]] Eigen::Vector2i image() const { return sides[1].begin.image - sides[0].begin.image; }
};

/// Grains, films and junctions: they tile the box.
struct FilmNetwork {
  std::vector<GrainPolygon> grains;  ///< grains by site
  std::vector<Film> films;
  std::vector<Junction> junctions;
  std::vector<std::vector<int>> segments;  ///< number of elements of each face of each grain

  [[nodiscard]] Eigen::Vector2d position(const CornerImage& corner) const {
    return grains[corner.grain].corners[corner.corner] + corner.image.cast<double>();
  }
  /// Whether the start (0) or the end (1) of a film is at a wall, and not at a junction with other films.
  [[nodiscard]] bool ends_at_wall(std::size_t film, std::size_t end) const {
    const auto& junction = junctions[films[film].junctions[end]];
    return junction.is_at_wall && junction.corners.size() <= 2;
  }
};

/// The network of films of one thickness [sides] in a tessellation (theory, section 17). Elements along a face are not
/// longer than `face_share` times the square root of the area of the smaller grain beside it. Where a face has vanished
/// on one side, the film is a triangle; where it has vanished on both, its two junctions become one. Throws InputError,
/// with all the sites, when grains vanish in their films.
[[nodiscard]] FilmNetwork film_network(const Tessellation<2>& tessellation, double thickness, double face_share);

}  // namespace breccia::films
