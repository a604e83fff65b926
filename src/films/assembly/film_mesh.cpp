#include "films/assembly/film_mesh.hpp"

namespace breccia::films {
namespace {

std::vector<GrainMesh> meshes_of(const FilmNetwork& network) {
  std::vector<GrainMesh> meshes;
  for (std::size_t g = 0; g < network.grains.size(); ++g) {
    meshes.push_back(grain_mesh(network.grains[g], network.segments[g]));
  }
  return meshes;
}

FilmNetwork network_of(const FilmProblem<2>& problem) {
  require_sound(problem);
  return film_network(problem.tessellation, problem.thickness / problem.tessellation.side(),
                      problem.elements.face_share);
}

/// How the films are debonded. Where the face on the second side has vanished there is no interface for springs.
std::vector<std::optional<Debonding>> debonding_of(const FilmNetwork& network, const DebondedFilms<2>& films) {
  const DebondedSet<2> debonded(films);
  std::vector<std::optional<Debonding>> debonding;
  for (const auto& film : network.films) {
    const auto kind = debonded(film.grains(), film.image());
    debonding.push_back(kind == Debonding::spring && !film.sides[1].face ? std::nullopt : kind);
  }
  return debonding;
}

std::vector<bool> on_springs(const std::vector<std::optional<Debonding>>& debonding) {
  std::vector<bool> are;
  are.reserve(debonding.size());
  for (const auto& kind : debonding) are.push_back(kind == Debonding::spring);
  return are;
}

}  // namespace

FilmMesh::FilmMesh(const FilmProblem<2>& problem)
    : network_(network_of(problem)),
      grains_(meshes_of(network_)),
      debonding_(debonding_of(network_, problem.debonded)),
      stiffness_(in_sides_of_the_box(problem.debonded.springs, problem.tessellation.side())),
      unknowns_(network_, grains_, problem.boundary, on_springs(debonding_)) {}

std::vector<NodeImage> FilmMesh::nodes_of(const Junction& junction) const {
  std::vector<NodeImage> nodes;
  for (const auto& corner : junction.corners) nodes.push_back(node_of(corner));
  return nodes;
}

/// The node of a film's side with an index along it: the ends and middles of its elements, in turn.
NodeImage FilmMesh::node_of_side(const Film& film, std::size_t side, int index_along) const {
  const auto& [begin, end, face] = film.sides[side];
  if (!face) return node_of(begin);
  const int past = side == 0 ? index_along : 2 * film.segments - index_along;
  return {begin.grain, unknowns_.node(begin.grain, *face, past), begin.image};
}

std::array<NodeImage, 6> FilmMesh::nodes_of_stretch(std::size_t film, int element) const {
  std::array<NodeImage, 6> nodes;
  for (std::size_t side = 0; side < 2; ++side) {
    for (int k = 0; k < 3; ++k) {
      nodes[3 * side + static_cast<std::size_t>(k)] = node_of_side(network_.films[film], side, 2 * element + k);
    }
  }
  return nodes;
}

FilmStretch FilmMesh::stretch(std::size_t film, int element) const {
  const auto nodes = nodes_of_stretch(film, element);
  const auto& [sides, direction, normal, thickness, junctions, segments] = network_.films[film];
  return {.ends = {{{position(nodes[0]), position(nodes[2])}, {position(nodes[3]), position(nodes[5])}}},
          .direction = direction,
          .normal = normal,
          .thickness = thickness};
}

InterfaceSprings FilmMesh::springs(std::size_t film, int element) const {
  InterfaceSprings springs;
  springs.jumps = unknowns_.jumps(film, element);
  if (springs.jumps.empty()) return springs;
  const auto of_element = stretch(film, element);
  const auto& [first, second] = of_element.ends;
  const double length = (second[1] - second[0]).norm();
  // The integrals of the products of quadratic functions along an element of length 1.
  const Eigen::Matrix3d products = Eigen::Matrix3d{{4.0, 2.0, -1.0}, {2.0, 16.0, 2.0}, {-1.0, 2.0, 4.0}} / 30.0;
  springs.stiffness = spring_stiffness(stiffness_, network_.films[film].normal, length * products);
  springs.outflow.setZero(FilmElement::pressures, std::ssize(springs.jumps));
  const auto out_of = [](const Eigen::Vector2d& end) { return Eigen::RowVector2d(0.5 * end.y(), -0.5 * end.x()); };
  if (element == 0) springs.outflow.topLeftCorner<1, 2>() = out_of(second[0] - first[0]);
  if (element == network_.films[film].segments - 1) {
    springs.outflow.bottomRightCorner<1, 2>() = out_of(first[1] - second[1]);
  }
  return springs;
}

Eigen::Vector2d FilmMesh::cut(std::size_t film, std::size_t end) const {
  const auto& corners = network_.junctions[network_.films[film].junctions[end]].corners;
  return network_.position(corners.front()) - network_.position(corners.back());
}

}  // namespace breccia::films
