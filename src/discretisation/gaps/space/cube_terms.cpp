#include "discretisation/gaps/space/cube_terms.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include <Eigen/Eigenvalues>

#include "microstructure/vector_algebra.hpp"

namespace breccia::gaps {
namespace {

/// The slope of a displacement component between two nodes that are neighbours along an axis.
LinearForm<3> slope_between(int node, std::size_t along, std::size_t component) {
  const int beside = CubePlace::beside(node, along);
  const double upwards = CubePlace::is_upper(beside, along) ? 1.0 : -1.0;
  return LinearForm<3>()
      .add(displacement_of<3>(beside, component), upwards)
      .add(displacement_of<3>(node, component), -upwards);
}

/// The neighbour of a node along an axis that belongs to its particle, the deeper one of two; nothing if there is none.
std::optional<Index<3>> own_neighbour(const GapGeometry<3>& geometry, const Index<3>& node, std::size_t along) {
  const auto owner = geometry.owners.of(node);
  constexpr double nothing = 1e-9;
  std::optional<Index<3>> deepest;
  double least = std::numeric_limits<double>::infinity();
  for (const int step : {-1, 1}) {
    auto neighbour = node;
    neighbour[along] += step;
    if (geometry.owners.of(neighbour) != owner) continue;
    const double distance = geometry.images.distance(
        owner,
        {static_cast<double>(neighbour[0]), static_cast<double>(neighbour[1]), static_cast<double>(neighbour[2])});
    // Of two as deep, the lower one, at all images of a node.
    if (distance > least - nothing) continue;
    deepest = neighbour;
    least = distance;
  }
  return deepest;
}

void tie_slope(const GapGeometry<3>& geometry, const CubePlace& place, int node, const Slope& slope,
               std::vector<SquareTerm<3>>& terms) {
  const auto owner = place.owner(node);
  const auto& [component, along] = slope;
  const auto own = LinearForm<3>().add(slope_at(node, slope), 1.0);
  // A little stiffness of the binder, so that no cell is without, keeps the slope to that of the edge.
  constexpr double little = 0.0005;
  auto of_edge = own;
  of_edge.add(-1.0, slope_between(node, along, component));
  terms.push_back({geometry.matrix, little, of_edge});
  const auto has = [&](const Index<3>& neighbour, std::size_t axis) {
    return place.node(CubePlace::beside(node, axis)) == neighbour;
  };
  if (const auto neighbour = own_neighbour(geometry, place.node(node), along)) {
    if (has(*neighbour, along)) terms.push_back({geometry.phase_at_surface(owner), 1.0, of_edge});
    return;
  }
  // Otherwise it has the rotation of the particle, from one neighbour along the component, so that the particle may
  // bend there; zero where there is none.
  auto rotation = own;
  if (const auto neighbour = own_neighbour(geometry, place.node(node), component)) {
    if (!has(*neighbour, component)) return;
    rotation.add(1.0, slope_between(node, component, along));
  }
  terms.push_back({geometry.phase_at_surface(owner), 1.0, rotation});
}

}  // namespace

CellUnknowns<3> volume_change(const CubePlace& place) {
  CellUnknowns<3> volume = CellUnknowns<3>::Zero();
  for (int face = 0; face < faces_of_cell<3>; ++face) {
    const double out = CubePlace::out_of(face);
    const auto& of_face = place.face(face);
    const auto where = place.face_place(face);
    for (std::size_t number = 0; number < of_face.flux.of_nodes.size(); ++number) {
      const auto node = static_cast<int>(node_of_face(static_cast<std::size_t>(face), number));
      volume[displacement_of<3>(node, where.normal)] += out * of_face.flux.of_nodes[number];
      for (std::size_t along = 0; along < 2; ++along) {
        if (!of_face.has_slope(number, along)) continue;
        volume[slope_at(node, {where.normal, where.axis(along)})] += out * of_face.flux.of_slopes[number][along];
      }
    }
    if (of_face.has_flow()) volume[flow_through_cube(face)] -= out * of_face.unit_of_flow();
  }
  return volume;
}

void tie_slopes(const GapGeometry<3>& geometry, const CubePlace& place, std::vector<SquareTerm<3>>& terms) {
  for (int node = 0; node < CellShape<3>::nodes; ++node) {
    for (const auto& slope : slopes_of_node) {
      const bool exists = geometry.faces.slope(place.node(node), slope) != GapCell<3>::none;
      if (exists) tie_slope(geometry, place, node, slope, terms);
    }
  }
}

WidthAt width_between(const ParticleImages<3>& images, ImageIndex first, ImageIndex second) {
  return [&images, first, second](const Vector<3>& point) -> GapWidth {
    return {images.distance(first, point) + images.distance(second, point),
            images.normal(first, point) + images.normal(second, point)};
  };
}

std::optional<FacetOfCell> facet_of(const GapGeometry<3>& geometry, const CubePlace& place) {
  if (!place.is_in_gap() || place.owners().size() != 2) return std::nullopt;
  auto found = corners_of_facet(place.changes());
  if (!found) return std::nullopt;
  for (auto& corner : found->corners) corner += place.corner();
  const auto width = width_between(geometry.images, place.owners()[0], place.owners()[1]);
  return FacetOfCell{make_facet(found->corners, width), found->faces};
}

void add_flow(const GapGeometry<3>& geometry, const CubePlace& place, const std::optional<FacetOfCell>& facet,
              std::vector<SquareTerm<3>>& terms) {
  const bool has_facet = facet && facet->facet.resistance.maxCoeff() > 0.0;
  for (int face = 0; face < faces_of_cell<3>; ++face) {
    const bool is_of_facet =
        has_facet && std::ranges::find(facet->faces, static_cast<std::size_t>(face)) != facet->faces.end();
    if (is_of_facet || !place.face(face).has_flow()) continue;
    // Of a flow per unknown: 1/2 (g / 2) q^2 / c.
    terms.push_back({geometry.matrix, 0.5, LinearForm<3>().add(flow_through_cube(face), 1.0)});
  }
  if (!has_facet) return;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(facet->facet.resistance);
  for (Eigen::Index mode = 0; mode < modes.eigenvalues().size(); ++mode) {
    LinearForm<3> form;
    for (std::size_t edge = 0; edge < facet->faces.size(); ++edge) {
      const auto face = static_cast<int>(facet->faces[edge]);
      if (!place.face(face).has_flow()) continue;
      form.add(flow_through_cube(face), modes.eigenvectors()(static_cast<Eigen::Index>(edge), mode) *
                                            CubePlace::out_of(face) * place.face(face).unit_of_flow());
    }
    // A facet in the corner of a cell may have no face with a flow.
    if (!form.is_empty()) terms.push_back({geometry.matrix, std::max(modes.eigenvalues()[mode], 0.0), form});
  }
}

}  // namespace breccia::gaps
