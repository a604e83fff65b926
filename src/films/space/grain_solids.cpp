#include "films/space/grain_solids.hpp"

#include <algorithm>
#include <span>
#include <tuple>
#include <utility>

#include "films/space/solid_elements.hpp"

namespace breccia::films {
namespace {

using TriangleCorners = std::array<std::size_t, 3>;  ///< corners of a triangle, counter-clockwise from outside

/// Fills a grain with tetrahedra of ten nodes, from the triangles of its surface inwards.
class Filling {
 public:
  explicit Filling(GrainSolid& solid) : solid_(solid) {
    for (const auto& node : solid.nodes) centre_ += node / static_cast<double>(solid.nodes.size());
  }

  /// Sets the middle of an edge of the surface, which is a node already.
  void set_middle(std::size_t a, std::size_t b, std::size_t middle) { middles_[std::minmax(a, b)] = middle; }

  /// Adds a shell of tetrahedra below triangles, down to a share of their distance from the centre. Returns the
  /// triangles below.
  std::vector<TriangleCorners> add_shell(const std::vector<TriangleCorners>& outside, double share) {
    std::map<std::size_t, std::size_t> below;
    for (const auto& triangle : outside) {
      for (const auto corner : triangle) {
        const auto [found, is_new] = below.try_emplace(corner, solid_.nodes.size());
        if (is_new) solid_.nodes.emplace_back(centre_ + share * (solid_.nodes[corner] - centre_));
      }
    }
    std::vector<TriangleCorners> inside;
    for (auto [a, b, c] : outside) {
      // The diagonal of each side of the wedge begins at its outer corner with the smaller number.
      while (a > b || a > c) std::tie(a, b, c) = std::tuple(b, c, a);
      const auto under_a = below.at(a), under_b = below.at(b), under_c = below.at(c);
      add({a, under_a, under_b, under_c});
      if (b < c) {
        add({a, b, c, under_c});
        add({a, b, under_b, under_c});
      } else {
        add({a, b, c, under_b});
        add({a, c, under_b, under_c});
      }
      inside.push_back({under_a, under_b, under_c});
    }
    return inside;
  }

  /// Adds a star of tetrahedra from triangles to the centre.
  void add_star(const std::vector<TriangleCorners>& outside) {
    const auto centre = solid_.nodes.size();
    solid_.nodes.push_back(centre_);
    for (const auto& [a, b, c] : outside) add({a, b, c, centre});
  }

 private:
  void add(std::array<std::size_t, 4> corners) {
    const auto at = [&](std::size_t i) -> const Eigen::Vector3d& { return solid_.nodes[corners[i]]; };
    if (volume_of({at(0), at(1), at(2), at(3)}) < 0.0) std::swap(corners[1], corners[2]);
    auto& nodes = solid_.tetrahedra.emplace_back();
    std::ranges::copy(corners, nodes.begin());
    for (std::size_t e = 0; e < edges_of_tetrahedron.size(); ++e) {
      nodes[corners.size() + e] = middle(corners[edges_of_tetrahedron[e][0]], corners[edges_of_tetrahedron[e][1]]);
    }
  }

  std::size_t middle(std::size_t a, std::size_t b) {
    const auto [found, is_new] = middles_.try_emplace(std::minmax(a, b), solid_.nodes.size());
    if (is_new) solid_.nodes.emplace_back(0.5 * (solid_.nodes[a] + solid_.nodes[b]));
    return found->second;
  }

  GrainSolid& solid_;
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> middles_;
};

/// Fills a grain of which the nodes of the surface are known: shells, and the star inside them.
void fill(GrainSolid& solid, const std::vector<std::array<std::size_t, 6>>& surface, std::span<const double> shells) {
  Filling filling(solid);
  std::vector<TriangleCorners> triangles;
  for (const auto& [a, b, c, ab, bc, ca] : surface) {
    filling.set_middle(a, b, ab);
    filling.set_middle(b, c, bc);
    filling.set_middle(c, a, ca);
    triangles.push_back({a, b, c});
  }
  double scale = 1.0;
  for (const double shell : shells) {
    triangles = filling.add_shell(triangles, shell / scale);
    scale = shell;
  }
  filling.add_star(triangles);
}

/// The shells of a grain, as shares of the distance of its surface from its centre. With one and two elements along an
/// edge a star without shells is fine enough; its error and that of the films are of opposite signs.
std::vector<double> shells_of(int divisions) {
  constexpr double depth = 0.8;
  std::vector<double> shares;
  for (int shell = 1; shell + 1 < divisions; ++shell) shares.push_back(1.0 - depth * shell / (divisions - 1));
  return shares;
}

}  // namespace

GrainSolids::GrainSolids(const CellComplex& complex, const SheetMesh& sheets, const std::vector<ShrunkGrain>& grains)
    : solids_(grains.size()), number_(grains.size()) {
  std::vector<std::vector<std::array<std::size_t, 6>>> surfaces(grains.size());
  const auto node_of = [&](std::size_t grain, const SheetNode& node) {
    const Key key = {node.number, {node.image.x(), node.image.y(), node.image.z()}};
    auto& nodes = solids_[grain].nodes;
    const auto [found, is_new] = number_[grain].try_emplace(key, nodes.size());
    if (is_new) nodes.push_back(grains[grain].place(sheets.position(node), Eigen::Vector3i::Zero()));
    return found->second;
  };
  for (const auto& triangle : sheets.triangles) {
    const auto& face = complex.faces[triangle.face];
    std::array<std::size_t, 6> of_first{}, of_second{};
    constexpr std::array<std::size_t, 6> reversed = {0, 2, 1, 5, 4, 3};
    for (std::size_t i = 0; i < of_first.size(); ++i) {
      of_first[i] = node_of(face.first, triangle.nodes[i]);
      const auto& node = triangle.nodes[reversed[i]];
      of_second[i] = node_of(face.second.cell, {node.number, node.image - face.second.image});
    }
    surfaces[face.first].push_back(of_first);
    surfaces[face.second.cell].push_back(of_second);
  }
  const auto shells = shells_of(sheets.divisions);
  for (std::size_t grain = 0; grain < grains.size(); ++grain) fill(solids_[grain], surfaces[grain], shells);
}

SolidNode GrainSolids::beside(const CellImage& grain, const SheetNode& node) const {
  const Eigen::Vector3i image = node.image - grain.image;
  return {grain.cell, number_[grain.cell].at({node.number, {image.x(), image.y(), image.z()}}), grain.image};
}

}  // namespace breccia::films
