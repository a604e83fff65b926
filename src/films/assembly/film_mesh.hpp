#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "breccia/films/film_problem.hpp"

#include "films/assembly/film_element.hpp"
#include "films/assembly/film_opening.hpp"
#include "films/assembly/unknowns.hpp"
#include "films/mesh/film_network.hpp"
#include "films/mesh/grain_mesh.hpp"

namespace breccia::films {

/// A node on the boundary of a grain, in an image of the box.
struct NodeImage {
  std::size_t grain = 0, number = 0;
  Eigen::Vector2i image;  ///< sides of the box by which the grain is displaced
};

/// Grains, films and junctions as elements, and the numbers of their unknowns. Lengths are in sides of the box.
class FilmMesh {
 public:
  explicit FilmMesh(const FilmProblem<2>& problem);

  [[nodiscard]] const FilmNetwork& network() const noexcept { return network_; }
  [[nodiscard]] const std::vector<GrainMesh>& grains() const noexcept { return grains_; }
  [[nodiscard]] const Unknowns& unknowns() const noexcept { return unknowns_; }

  [[nodiscard]] Eigen::Vector2d position(const NodeImage& node) const {
    return grains_[node.grain].nodes[node.number] + node.image.cast<double>();
  }
  [[nodiscard]] NodeImage node_of(const CornerImage& corner) const {
    return {corner.grain, unknowns_.node(corner.grain, corner.corner, 0), corner.image};
  }
  [[nodiscard]] std::vector<NodeImage> nodes_of(const Junction& junction) const;
  /// The nodes of an element of a film: start, middle and end of its first side, then of its second one.
  [[nodiscard]] std::array<NodeImage, 6> nodes_of_stretch(std::size_t film, int element) const;
  /// The shape of an element of a film.
  [[nodiscard]] FilmStretch stretch(std::size_t film, int element) const;
  /// The line of a wall between the two sides of a film that ends there, with the body on its left.
  [[nodiscard]] Eigen::Vector2d cut(std::size_t film, std::size_t end) const;
  /// The opening of a film that ends at a wall.
  [[nodiscard]] FilmOpening opening(std::size_t film, std::size_t end) const {
    return film_opening(network_.films[film].direction, cut(film, end));
  }

 private:
  [[nodiscard]] NodeImage node_of_side(const Film& film, std::size_t side, int index_along) const;

  FilmNetwork network_;
  std::vector<GrainMesh> grains_;
  Unknowns unknowns_;
};

}  // namespace breccia::films
