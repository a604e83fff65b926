#include "films/space/resolved_solids.hpp"

#include <algorithm>
#include <utility>

#include "films/mesh/grading.hpp"
#include "films/mesh/node_merger.hpp"
#include "films/space/solid_elements.hpp"

namespace breccia::films {
namespace {

/// The corners of a wedge: those of a triangle, and those opposite to them.
using WedgeCorners = std::array<Eigen::Vector3d, 6>;

/// The point of a line, a triangle or a tetrahedron at these shares of its corners, out of a number of divisions; the
/// shares are graded, so that points lie closer together near the corners.
template <std::size_t corners>
Eigen::Vector3d graded_point(const std::array<Eigen::Vector3d, corners>& of, const std::array<int, corners>& shares,
                             int divisions) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double weight = 0.0;
  for (std::size_t k = 0; k < corners; ++k) {
    const double share = graded(static_cast<double>(shares[k]) / divisions);
    sum += share * of[k];
    weight += share;
  }
  return sum / weight;
}

/// Gives corners and middles of edges their nodes, and collects tetrahedra.
class SolidMesher {
 public:
  void add_grain(const GrainSolid& solid, std::size_t number) {
    for (const auto& tetrahedron : solid.tetrahedra) {
      mesh_.grain_of_element.push_back(number);
      add({solid.nodes[tetrahedron[0]], solid.nodes[tetrahedron[1]], solid.nodes[tetrahedron[2]],
           solid.nodes[tetrahedron[3]]},
          mesh_.grains);
    }
  }

  void add_film(const Wedge& wedge, int layers) {
    const auto place = [&](std::size_t k, int layer) -> Eigen::Vector3d {
      return graded_point<2>({wedge.triangles[0][k], wedge.triangles[1][k]}, {layers - layer, layer}, layers);
    };
    for (int layer = 0; layer < layers; ++layer) {
      add_wedge({place(0, layer), place(1, layer), place(2, layer), place(0, layer + 1), place(1, layer + 1),
                 place(2, layer + 1)});
    }
  }

  /// `ends` are, for each grain, the start and the end of its edge.
  void add_channel(const std::array<std::array<Eigen::Vector3d, 2>, 3>& ends, int layers) {
    const auto place = [&](int i, int j, std::size_t end) -> Eigen::Vector3d {
      return graded_point<3>({ends[0][end], ends[1][end], ends[2][end]}, {layers - i - j, i, j}, layers);
    };
    const auto add_prism = [&](const std::array<std::array<int, 2>, 3>& corners) {
      WedgeCorners wedge;
      for (std::size_t end = 0; end < 2; ++end) {
        for (std::size_t k = 0; k < 3; ++k) wedge[3 * end + k] = place(corners[k][0], corners[k][1], end);
      }
      add_wedge(wedge);
    };
    for (int i = 0; i < layers; ++i) {
      for (int j = 0; i + j < layers; ++j) {
        add_prism({{{i, j}, {i + 1, j}, {i, j + 1}}});
        if (i + j + 1 < layers) add_prism({{{i + 1, j}, {i + 1, j + 1}, {i, j + 1}}});
      }
    }
  }

  /// Cuts the tetrahedron between four grains into a lattice of tetrahedra and octahedra, and the latter into four.
  void add_corner(const std::array<Eigen::Vector3d, 4>& corners, int layers) {
    for (int i = 0; i < layers; ++i) {
      for (int j = 0; i + j < layers; ++j) {
        for (int k = 0; i + j + k < layers; ++k) add_lattice_cell(corners, {i, j, k}, layers);
      }
    }
  }

  [[nodiscard]] ResolvedSolids take() {
    mesh_.nodes = merger_.positions();
    return std::move(mesh_);
  }

 private:
  void add(TetrahedronCorners corners, std::vector<QuadraticTetrahedron>& tetrahedra) {
    if (volume_of(corners) < 0.0) std::swap(corners[1], corners[2]);
    QuadraticTetrahedron made{{}, corners};
    for (std::size_t i = 0; i < corners.size(); ++i) made.nodes[i] = merger_.number(corners[i]);
    for (std::size_t e = 0; e < edges_of_tetrahedron.size(); ++e) {
      const auto& [begin, end] = edges_of_tetrahedron[e];
      made.nodes[4 + e] = merger_.number(0.5 * (corners[begin] + corners[end]));
    }
    tetrahedra.push_back(made);
  }

  /// Cuts a wedge into three tetrahedra. The diagonal of each of its sides begins at the corner with the smallest
  /// number, so that neighbours have the same ones (Dompierre, Labbe, Vallet and Camarero 1999).
  void add_wedge(const WedgeCorners& corners) {
    std::array<std::size_t, 6> numbers{};
    for (std::size_t i = 0; i < corners.size(); ++i) numbers[i] = merger_.number(corners[i]);
    const auto smallest = static_cast<std::size_t>(std::ranges::min_element(numbers) - numbers.begin());
    // The corners as seen from the smallest one: its triangle, and the corners opposite to that.
    std::array<std::size_t, 6> order{};
    const auto triangle = 3 * (smallest / 3), other = 3 - triangle;
    for (std::size_t k = 0; k < 3; ++k) {
      order[k] = triangle + (smallest + k) % 3;
      order[3 + k] = other + (smallest + k) % 3;
    }
    const auto number = [&](std::size_t i) { return numbers[order[i]]; };
    const auto tetrahedron = [&](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
      add({corners[order[i]], corners[order[j]], corners[order[k]], corners[order[l]]}, mesh_.binder);
    };
    tetrahedron(0, 3, 4, 5);
    if (std::min(number(1), number(5)) < std::min(number(2), number(4))) {
      tetrahedron(0, 1, 2, 5);
      tetrahedron(0, 1, 5, 4);
    } else {
      tetrahedron(0, 1, 2, 4);
      tetrahedron(0, 4, 2, 5);
    }
  }

  void add_lattice_cell(const TetrahedronCorners& corners, const std::array<int, 3>& at, int layers) {
    const auto place = [&](int i, int j, int k) -> Eigen::Vector3d {
      const std::array steps = {at[0] + i, at[1] + j, at[2] + k};
      return graded_point<4>(corners, {layers - steps[0] - steps[1] - steps[2], steps[0], steps[1], steps[2]}, layers);
    };
    const int left = layers - at[0] - at[1] - at[2];
    add({place(0, 0, 0), place(1, 0, 0), place(0, 1, 0), place(0, 0, 1)}, mesh_.binder);
    if (left < 2) return;
    const auto begin = place(1, 0, 0), end = place(0, 1, 1);
    const std::array around = {place(0, 1, 0), place(1, 1, 0), place(1, 0, 1), place(0, 0, 1)};
    for (std::size_t i = 0; i < around.size(); ++i) {
      add({begin, end, around[i], around[(i + 1) % around.size()]}, mesh_.binder);
    }
    if (left < 3) return;
    add({place(1, 1, 0), place(1, 0, 1), place(0, 1, 1), place(1, 1, 1)}, mesh_.binder);
  }

  NodeMerger<3> merger_{Walls::periodic};
  ResolvedSolids mesh_;
};

}  // namespace

ResolvedSolids resolved_solids(const SpaceMesh& mesh, int layers) {
  SolidMesher mesher;
  const auto& solids = mesh.grains().solids();
  for (std::size_t g = 0; g < solids.size(); ++g) mesher.add_grain(solids[g], g);
  for (std::size_t t = 0; t < mesh.sheets().triangles.size(); ++t) {
    if (!mesh.debonding(t)) mesher.add_film(mesh.film(t), layers);
  }
  for (std::size_t s = 0; s < mesh.sheets().segments.size(); ++s) mesher.add_channel(mesh.channel(s), layers);
  for (std::size_t p = 0; p < mesh.sheets().points.size(); ++p) mesher.add_corner(mesh.corner(p), layers);
  return mesher.take();
}

}  // namespace breccia::films
