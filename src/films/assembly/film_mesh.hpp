#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "breccia/films/film_problem.hpp"

#include "films/assembly/debonded_set.hpp"
#include "films/assembly/film_element.hpp"
#include "films/assembly/film_opening.hpp"
#include "films/assembly/interface_springs.hpp"
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
  /// Whether a film is debonded and carries nothing.
  [[nodiscard]] bool is_gap(std::size_t film) const { return films::is_gap(debonding_[film]); }
  /// Whether a gap is open to the junctions at its ends.
  [[nodiscard]] bool is_open(std::size_t film) const { return debonding_[film] == Debonding::open; }
  /// The part of the fields to which a film belongs.
  [[nodiscard]] FilmPart part(std::size_t film) const { return part_of_film(debonding_[film]); }
  /// Whether a film slides along its second side.
  [[nodiscard]] bool slides(std::size_t film) const { return debonding_[film] == Debonding::slip; }
  /// The springs of an element of a film that hold it to the grain on its second side; a bonded film has none. In units
  /// of the side of the box.
  [[nodiscard]] InterfaceSprings springs(std::size_t film, int element) const;
  /// Matrices of an element of a film; of a gap those that it would have if it were bonded.
  [[nodiscard]] FilmElement element(std::size_t film, int element) const {
    return slides(film) ? sliding_film_element(stretch(film, element)) : film_element(stretch(film, element));
  }
  /// Stiffness of the bend at an end of a film, of the length that end_lengths() gives, for a unit shear modulus. A
  /// film that slides is half of one twice as thick.
  [[nodiscard]] double bend(std::size_t film, double end_length) const {
    return (slides(film) ? 6.0 : 12.0) * end_length;
  }
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
  std::vector<std::optional<Debonding>> debonding_;  ///< by film
  InterfaceStiffness stiffness_;                     ///< of springs [Pa]
  Unknowns unknowns_;
};

}  // namespace breccia::films
