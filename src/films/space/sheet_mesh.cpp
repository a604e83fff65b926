#include "films/space/sheet_mesh.hpp"

#include <utility>

#include "films/mesh/node_merger.hpp"

namespace breccia::films {
namespace {

/// Gives points their nodes, and makes the elements of faces and edges.
class SheetMesher {
 public:
  SheetMesher(const CellComplex& complex, int divisions) : complex_(complex), divisions_(divisions) {}

  void add_face(std::size_t face) {
    const auto& corners = complex_.faces[face].corners;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    for (const auto& corner : corners) centre += complex_.position(corner) / static_cast<double>(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
      add_fan_triangle(face, centre, complex_.position(corners[i]),
                       complex_.position(corners[(i + 1) % corners.size()]));
    }
  }

  void add_edge(std::size_t edge) {
    const auto begin = complex_.position(complex_.edges[edge].ends[0]);
    const Eigen::Vector3d step = (complex_.position(complex_.edges[edge].ends[1]) - begin) / (2 * divisions_);
    for (int k = 0; k < divisions_; ++k) {
      mesh_.segments.push_back(
          {edge,
           {node_at(begin + 2 * k * step), node_at(begin + (2 * k + 1) * step), node_at(begin + (2 * k + 2) * step)}});
    }
  }

  void add_point(const SharedPoint& point) { mesh_.points.push_back(node_at(complex_.position(point.vertex))); }

  [[nodiscard]] SheetMesh take() {
    mesh_.divisions = divisions_;
    mesh_.nodes = merger_.positions();
    return std::move(mesh_);
  }

 private:
  [[nodiscard]] SheetNode node_at(const Eigen::Vector3d& position) {
    const auto number = merger_.number(position);
    const Eigen::Vector3d displacement = position - merger_.positions()[number];
    return {number, displacement.array().round().matrix().cast<int>()};
  }

  void add_fan_triangle(std::size_t face, const Eigen::Vector3d& centre, const Eigen::Vector3d& first,
                        const Eigen::Vector3d& second) {
    const Eigen::Vector3d a = (first - centre) / (2 * divisions_), b = (second - centre) / (2 * divisions_);
    // A triangle with a corner at (i, j) of a lattice of steps 2 a and 2 b; its edges lead along the steps or back.
    const auto add = [&](int i, int j, int direction, bool is_at_rim) {
      const auto node = [&](int along_a, int along_b) {
        return node_at(centre + (2 * i + direction * along_a) * a + (2 * j + direction * along_b) * b);
      };
      mesh_.triangles.push_back(
          {face, {node(0, 0), node(2, 0), node(0, 2), node(1, 0), node(1, 1), node(0, 1)}, is_at_rim});
    };
    for (int i = 0; i <= divisions_; ++i) {
      for (int j = 0; i + j <= divisions_; ++j) {
        if (i + j < divisions_) add(i, j, 1, i + j == divisions_ - 1);
        if (i > 0 && j > 0) add(i, j, -1, false);
      }
    }
  }

  const CellComplex& complex_;
  int divisions_;
  NodeMerger<3> merger_{Walls::periodic};
  SheetMesh mesh_;
};

}  // namespace

SheetMesh sheet_mesh(const CellComplex& complex, int divisions) {
  SheetMesher mesher(complex, divisions);
  for (std::size_t face = 0; face < complex.faces.size(); ++face) mesher.add_face(face);
  for (std::size_t edge = 0; edge < complex.edges.size(); ++edge) mesher.add_edge(edge);
  for (const auto& point : complex.points) mesher.add_point(point);
  return mesher.take();
}

}  // namespace breccia::films
