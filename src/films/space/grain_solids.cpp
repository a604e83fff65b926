#include "films/space/grain_solids.hpp"

namespace breccia::films {
namespace {

using SurfaceTriangle = std::array<std::size_t, 6>;

/// Adds the centre, the middles of the edges that lead to it, and the tetrahedra. The triangles are counter-clockwise
/// from outside.
void fill(GrainSolid& solid, const std::vector<SurfaceTriangle>& surface) {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  const auto on_surface = solid.nodes.size();
  for (const auto& node : solid.nodes) centre += node / static_cast<double>(on_surface);
  solid.nodes.push_back(centre);
  std::map<std::size_t, std::size_t> middles;
  const auto middle = [&](std::size_t corner) {
    const auto [found, is_new] = middles.try_emplace(corner, solid.nodes.size());
    if (is_new) solid.nodes.emplace_back(0.5 * (solid.nodes[corner] + centre));
    return found->second;
  };
  for (const auto& [a, b, c, ab, bc, ca] : surface) {
    // Seen from the centre, the triangle is clockwise.
    solid.tetrahedra.push_back({a, c, b, on_surface, ca, bc, ab, middle(a), middle(c), middle(b)});
  }
}

}  // namespace

GrainSolids::GrainSolids(const CellComplex& complex, const SheetMesh& sheets, const std::vector<ShrunkGrain>& grains)
    : solids_(grains.size()), number_(grains.size()) {
  std::vector<std::vector<SurfaceTriangle>> surfaces(grains.size());
  const auto node_of = [&](std::size_t grain, const SheetNode& node) {
    const Key key = {node.number, {node.image.x(), node.image.y(), node.image.z()}};
    auto& nodes = solids_[grain].nodes;
    const auto [found, is_new] = number_[grain].try_emplace(key, nodes.size());
    if (is_new) nodes.push_back(grains[grain].place(sheets.position(node), Eigen::Vector3i::Zero()));
    return found->second;
  };
  for (const auto& triangle : sheets.triangles) {
    const auto& face = complex.faces[triangle.face];
    SurfaceTriangle of_first{}, of_second{};
    constexpr std::array<std::size_t, 6> reversed = {0, 2, 1, 5, 4, 3};
    for (std::size_t i = 0; i < of_first.size(); ++i) {
      of_first[i] = node_of(face.first, triangle.nodes[i]);
      const auto& node = triangle.nodes[reversed[i]];
      of_second[i] = node_of(face.second.cell, {node.number, node.image - face.second.image});
    }
    surfaces[face.first].push_back(of_first);
    surfaces[face.second.cell].push_back(of_second);
  }
  for (std::size_t grain = 0; grain < grains.size(); ++grain) fill(solids_[grain], surfaces[grain]);
}

SolidNode GrainSolids::beside(const CellImage& grain, const SheetNode& node) const {
  const Eigen::Vector3i image = node.image - grain.image;
  return {grain.cell, number_[grain.cell].at({node.number, {image.x(), image.y(), image.z()}}), grain.image};
}

}  // namespace breccia::films
