#include "films/mesh/resolved_mesh.hpp"

#include <cmath>
#include <span>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "films/assembly/debonded_set.hpp"
#include "films/mesh/film_network.hpp"
#include "films/mesh/grading.hpp"
#include "films/mesh/grain_mesh.hpp"
#include "films/mesh/node_merger.hpp"

namespace breccia::films {
namespace {

/// A part of the binder between a base and, on its left, a top, which may be a single point.
struct Patch {
  std::array<Eigen::Vector2d, 2> base, top;  ///< start and end; both run in the same direction
};

/// Fills patches with rows of elements. Patches share the nodes of a common side if they divide it at the same shares.
class MeshBuilder {
 public:
  explicit MeshBuilder(Walls walls) : nodes_(walls) {}

  void add_grain(const GrainMesh& grain, std::size_t number) {
    for (const auto& triangle : grain.triangles) {
      mesh_.grain_of_element.push_back(number);
      mesh_.grains.push_back(
          triangle_of({grain.nodes[triangle[0]], grain.nodes[triangle[1]], grain.nodes[triangle[2]]}));
    }
  }

  /// Adds the elements of a patch. `along` and `across` are the shares, from 0 to 1, at which the rows of elements
  /// start and end.
  void add_patch(const Patch& patch, std::span<const double> along, std::span<const double> across) {
    const auto at = [&](std::size_t column, std::size_t row) -> Eigen::Vector2d {
      const auto on = [&](const auto& line) -> Eigen::Vector2d {
        return line[0] + along[column] * (line[1] - line[0]);
      };
      return (1.0 - across[row]) * on(patch.base) + across[row] * on(patch.top);
    };
    const bool is_pointed = patch.top[0] == patch.top[1];
    for (std::size_t row = 0; row + 1 < across.size(); ++row) {
      for (std::size_t column = 0; column + 1 < along.size(); ++column) {
        if (is_pointed && row + 2 == across.size()) {
          mesh_.triangles.push_back(triangle_of({at(column, row), at(column + 1, row), patch.top[0]}));
        } else {
          mesh_.quadrilaterals.push_back(
              quadrilateral_of({at(column, row), at(column + 1, row), at(column + 1, row + 1), at(column, row + 1)}));
        }
      }
    }
  }

  [[nodiscard]] ResolvedMesh finish() {
    mesh_.nodes = nodes_.positions();
    return std::move(mesh_);
  }

 private:
  template <std::size_t corners, std::size_t count>
  void number_edges(MeshElement<corners, count>& element) {
    const auto& positions = element.positions;
    for (std::size_t c = 0; c < corners; ++c) {
      element.nodes[c] = nodes_.number(positions[c]);
      element.nodes[corners + c] = nodes_.number(0.5 * (positions[c] + positions[(c + 1) % corners]));
    }
  }

  MeshTriangle triangle_of(const std::array<Eigen::Vector2d, 3>& corners) {
    MeshTriangle triangle{{}, corners};
    number_edges(triangle);
    return triangle;
  }

  MeshQuadrilateral quadrilateral_of(const std::array<Eigen::Vector2d, 4>& corners) {
    MeshQuadrilateral quadrilateral{{}, corners};
    number_edges(quadrilateral);
    quadrilateral.nodes.back() = nodes_.number(0.25 * (corners[0] + corners[1] + corners[2] + corners[3]));
    return quadrilateral;
  }

  NodeMerger<2> nodes_;
  ResolvedMesh mesh_;
};

/// Shares of the thickness at which layers start and end, from one face to the other.
std::vector<double> layers_across(int layers) {
  std::vector<double> shares;
  for (int k = 0; k <= layers; ++k) shares.push_back(graded(1.0 * k / layers));
  return shares;
}

/// Shares of the distance from the corner of a grain, where the rows are thinner, to the centre of a junction.
std::vector<double> layers_inward(int layers) {
  std::vector<double> shares;
  for (int k = 0; k <= layers; ++k) shares.push_back(2.0 * graded(0.5 * k / layers));
  return shares;
}

double length_of(const FilmNetwork& network, const FilmSide& side) {
  return (network.position(side.end) - network.position(side.begin)).norm();
}

/// Fills the binder around a junction with a fan from its centre.
void add_junction(MeshBuilder& mesh, const FilmNetwork& network, const Junction& junction, int layers) {
  if (junction.corners.size() < 3) return;
  std::vector<Eigen::Vector2d> corners;
  for (const auto& corner : junction.corners) corners.push_back(network.position(corner));
  const Eigen::Vector2d centre = centroid(corners);
  for (std::size_t c = 0; c < corners.size(); ++c) {
    const Eigen::Vector2d &begin = corners[c], &end = corners[(c + 1) % corners.size()];
    if (!(area({begin, end, centre}) > 0.0)) {
      throw InputError(
          fmt::format("films: the binder around ({:.4g}, {:.4g}) sides of the box, where {} grains meet, is too narrow "
                      "to be meshed; "
                      "a thinner film or other sites avoid it, and thin films (without layers) do without a mesh there",
                      centre.x(), centre.y(), corners.size()));
    }
    mesh.add_patch({.base = {begin, end}, .top = {centre, centre}}, layers_across(layers), layers_inward(layers));
  }
}

}  // namespace

ResolvedMesh resolved_mesh(const FilmProblem<2>& problem) {
  const double thickness = problem.thickness / problem.tessellation.side();
  const int layers = *problem.layers;
  const auto network = film_network(problem.tessellation, thickness, problem.elements.face_share);
  const DebondedSet<2> debonded(problem.debonded);
  const auto across = layers_across(layers);
  const double shortest = across[1] * thickness;
  MeshBuilder mesh(problem.tessellation.walls());

  std::vector<std::vector<std::vector<double>>> divisions;  // divisions by grain and face
  for (std::size_t g = 0; g < network.grains.size(); ++g) {
    const auto& grain = network.grains[g];
    auto& of_grain = divisions.emplace_back();
    for (std::size_t face = 0; face < grain.corners.size(); ++face) {
      const double length = (grain.corners[grain.next_corner(face)] - grain.corners[face]).norm();
      of_grain.push_back(graded_divisions(length, shortest, length / network.segments[g][face]));
    }
  }
  for (const auto& film : network.films) {
    const auto& [one, other] = film.sides;
    const double length = std::max(length_of(network, one), length_of(network, other));
    const auto along = graded_divisions(length, shortest, length / film.segments);
    for (const auto& side : film.sides) {
      if (side.face) divisions[side.begin.grain][*side.face] = along;
    }
    if (debonded(film.grains(), film.image())) continue;
    mesh.add_patch({.base = {network.position(one.end), network.position(one.begin)},
                    .top = {network.position(other.end), network.position(other.begin)}},
                   along, across);
  }
  for (const auto& junction : network.junctions) add_junction(mesh, network, junction, layers);
  for (std::size_t g = 0; g < network.grains.size(); ++g) {
    for (auto& shares : divisions[g]) shares.pop_back();
    mesh.add_grain(grain_mesh(network.grains[g], divisions[g]), g);
  }
  return mesh.finish();
}

}  // namespace breccia::films
