#include "films/space/space_mesh.hpp"

#include <map>
#include <numeric>
#include <tuple>

#include <Eigen/Geometry>

#include "films/space/film_wedge.hpp"
#include "films/space/solid_unknowns.hpp"

namespace breccia::films {
namespace {

std::vector<ShrunkGrain> grains_of(const FilmProblem<3>& problem, const CellComplex& complex) {
  return shrunk_grains(problem.tessellation, complex, grain_fraction(problem.tessellation, problem.thickness));
}

}  // namespace

SpaceMesh::SpaceMesh(const FilmProblem<3>& problem)
    : complex_(cell_complex(problem.tessellation)),
      sheets_(sheet_mesh(complex_, problem.elements.divisions)),
      solids_(complex_, sheets_, grains_of(problem, complex_)),
      stiffness_(in_sides_of_the_box(problem.debonded.springs, problem.tessellation.side())) {
  int nodes = 0;
  for (const auto& solid : solids_.solids()) {
    first_node_.push_back(nodes);
    nodes += static_cast<int>(solid.nodes.size());
  }
  first_flow_ = displacements_of(nodes);
  const DebondedSet<3> debonded(problem.debonded);
  for (const auto& [first, second, corners] : complex_.faces) {
    debonding_.push_back(debonded({first, second.cell}, second.image));
  }
  unknowns_ = first_flow_ + FilmWedge::flows * static_cast<int>(sheets_.triangles.size());
  number_jumps();
}

/// Numbers the jumps of films on springs: they are those of a face, continuous from triangle to triangle.
void SpaceMesh::number_jumps() {
  using NodeOfFace = std::tuple<std::size_t, std::size_t, int, int, int>;  // face, number of the node, its image
  std::map<NodeOfFace, int> first_jump;
  for (const auto& [face, nodes, is_at_rim] : sheets_.triangles) {
    auto& jumps = jumps_.emplace_back();
    if (debonding_[face] != Debonding::spring) continue;
    for (const auto& [number, image] : nodes) {
      const auto [found, is_new] = first_jump.try_emplace({face, number, image.x(), image.y(), image.z()}, unknowns_);
      if (is_new) unknowns_ += 3;
      for (int i = 0; i < 3; ++i) jumps.push_back(found->second + i);
    }
  }
}

InterfaceSprings SpaceMesh::springs(std::size_t triangle) const {
  InterfaceSprings springs;
  springs.jumps = jumps_[triangle];
  if (springs.jumps.empty()) return springs;
  const auto wedge = film(triangle);
  const auto& corners = wedge.triangles[1];
  const Eigen::Vector3d twice_area = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  const auto& [places, weights] = triangle_rule();
  Eigen::Matrix<double, 6, 6> products = Eigen::Matrix<double, 6, 6>::Zero();
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto functions = quadratic_in_triangle(places[i]);
    products += 0.5 * twice_area.norm() * weights[i] * functions * functions.transpose();
  }
  springs.stiffness = spring_stiffness(stiffness_, twice_area.normalized(), products);
  springs.outflow.setZero(FilmWedge::pressures, std::ssize(springs.jumps));
  if (sheets_.triangles[triangle].is_at_rim) springs.outflow = outflow_of_second_side(wedge);
  return springs;
}

std::array<int, 6> SpaceMesh::flows_of(std::size_t triangle) const {
  std::array<int, 6> flows{};
  std::iota(flows.begin(), flows.end(), first_flow_ + static_cast<int>(flows.size() * triangle));
  return flows;
}

ElementUnknowns<3> SpaceMesh::unknowns_of(std::span<const SolidNode> nodes, std::span<const int> flows) const {
  std::vector<ElementNode> of_element;
  of_element.reserve(nodes.size());
  for (const auto& node : nodes) of_element.push_back({number(node), solids_.position(node)});
  return solid_unknowns(of_element, flows);
}

std::array<SolidNode, 12> SpaceMesh::nodes_of_film(std::size_t triangle) const {
  const auto& [number, nodes, is_at_rim] = sheets_.triangles[triangle];
  const auto& face = complex_.faces[number];
  std::array<SolidNode, 12> found;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    found[i] = solids_.beside({face.first, Eigen::Vector3i::Zero()}, nodes[i]);
    found[nodes.size() + i] = solids_.beside(face.second, nodes[i]);
  }
  return found;
}

Wedge SpaceMesh::film(std::size_t triangle) const {
  const auto nodes = nodes_of_film(triangle);
  Wedge wedge;
  for (std::size_t side = 0; side < 2; ++side) {
    for (std::size_t k = 0; k < 3; ++k) wedge.triangles[side][k] = solids_.position(nodes[6 * side + k]);
  }
  return wedge;
}

std::array<SolidNode, 9> SpaceMesh::nodes_of_channel(std::size_t segment) const {
  const auto& [number, nodes] = sheets_.segments[segment];
  const auto& cells = complex_.edges[number].cells;
  std::array<SolidNode, 9> found;
  for (std::size_t grain = 0; grain < cells.size(); ++grain) {
    for (std::size_t k = 0; k < nodes.size(); ++k) found[3 * grain + k] = solids_.beside(cells[grain], nodes[k]);
  }
  return found;
}

std::array<std::array<Eigen::Vector3d, 2>, 3> SpaceMesh::channel(std::size_t segment) const {
  const auto nodes = nodes_of_channel(segment);
  std::array<std::array<Eigen::Vector3d, 2>, 3> ends;
  for (std::size_t grain = 0; grain < ends.size(); ++grain) {
    ends[grain] = {solids_.position(nodes[3 * grain]), solids_.position(nodes[3 * grain + 2])};
  }
  return ends;
}

std::array<SolidNode, 4> SpaceMesh::nodes_of_corner(std::size_t point) const {
  const auto& cells = complex_.points[point].cells;
  const auto& node = sheets_.points[point];
  return {solids_.beside(cells[0], node), solids_.beside(cells[1], node), solids_.beside(cells[2], node),
          solids_.beside(cells[3], node)};
}

std::array<Eigen::Vector3d, 4> SpaceMesh::corner(std::size_t point) const {
  const auto nodes = nodes_of_corner(point);
  return {solids_.position(nodes[0]), solids_.position(nodes[1]), solids_.position(nodes[2]),
          solids_.position(nodes[3])};
}

}  // namespace breccia::films
