#include "unknowns.hpp"

#include <algorithm>
#include <utility>

namespace disc_packings {
namespace {

std::vector<int> nodes_on_walls(const Mesh& mesh) {
  std::vector<int> nodes;
  for (int node = 0; node < static_cast<int>(mesh.is_on_wall.size()); ++node) {
    if (mesh.is_on_wall[node]) nodes.push_back(node);
  }
  return nodes;
}

/// A node on the wall at the bottom and one on the wall at the top. To hold both of the first and x of the second takes
/// away all rigid motions.
std::vector<int> bottom_and_top(const Mesh& mesh) {
  std::pair<double, int> bottom = {1.0, -1};
  std::pair<double, int> top = {0.0, -1};
  for (const MeshElement& element : mesh.elements) {
    for (std::size_t i = 0; i < element.nodes.size(); ++i) {
      const std::pair<double, int> node = {element.points[i].y(), element.nodes[i]};
      bottom = std::min(bottom, node);
      top = std::max(top, node);
    }
  }
  return {bottom.second, top.second};
}

/// The nodes whose unknowns come before all others.
std::vector<int> first_nodes(const Mesh& mesh, Filler filler, Boundary boundary) {
  if (boundary == Boundary::displacement) return nodes_on_walls(mesh);
  if (boundary == Boundary::traction && filler == Filler::deformable) return bottom_and_top(mesh);
  return {};  // the first unknowns are those of a rigid disc or, in a periodic box, of any node
}

int count_held(Boundary boundary, const std::vector<int>& first_nodes) {
  switch (boundary) {
    case Boundary::periodic:
      return 2;
    case Boundary::traction:
      return 3;
    case Boundary::displacement:
      break;
  }
  return 2 * static_cast<int>(first_nodes.size());
}

}  // namespace

Unknowns number_unknowns(const Mesh& mesh, const Packing& packing, Filler filler, Boundary boundary) {
  const bool is_rigid = filler == Filler::rigid;
  constexpr int none = -1;
  Unknowns unknowns = {0, 0, 0, std::vector<int>(mesh.disc_of_arc.size(), none)};
  const auto add = [&](int node) {
    unknowns.first_of_node[node] = unknowns.count;
    unknowns.count += 2;
  };
  const std::vector<int> first = first_nodes(mesh, filler, boundary);
  unknowns.held = count_held(boundary, first);
  for (const int node : first) add(node);
  unknowns.first_of_first_disc = unknowns.count;
  if (is_rigid) unknowns.count += 3 * static_cast<int>(packing.size());
  for (int node = 0; node < static_cast<int>(mesh.disc_of_arc.size()); ++node) {
    const bool follows_disc = is_rigid && mesh.disc_of_arc[node] >= 0;
    if (!follows_disc && unknowns.first_of_node[node] == none) add(node);
  }
  return unknowns;
}

}  // namespace disc_packings
