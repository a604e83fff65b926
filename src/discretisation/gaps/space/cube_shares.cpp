#include "discretisation/gaps/space/cube_shares.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "microstructure/vector_algebra.hpp"

namespace breccia::gaps {
namespace {

using Shape = CellShape<3>;
using NodeValues = Eigen::Matrix<double, Shape::nodes, 1>;
using Gradients = Eigen::Matrix<double, 3, Shape::nodes>;

constexpr double rounding = 1e-9;

/// The gradients of the shape functions of the nodes at each point of a cell.
std::array<Gradients, Shape::points> gradients_at_points() {
  std::array<Gradients, Shape::points> gradients;
  for (int point = 0; point < Shape::points; ++point) {
    const auto offset = Shape::offset(point);
    for (int node = 0; node < Shape::nodes; ++node) {
      const auto corner = Shape::corner(node);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        double slope = corner[axis] == 1 ? 1.0 : -1.0;
        for (std::size_t other = 0; other < 3; ++other) {
          if (other != axis) slope *= 0.5 + (corner[other] == 1 ? offset[other] : -offset[other]);
        }
        gradients[static_cast<std::size_t>(point)](static_cast<Eigen::Index>(axis), node) = slope;
      }
    }
  }
  return gradients;
}

/// The mean over the points of a cell of the product of the gradients of two fields.
double mean_product(const NodeValues& one, const NodeValues& other) {
  static const auto gradients = gradients_at_points();
  double sum = 0.0;
  for (const auto& gradient : gradients) sum += (gradient * one).dot(gradient * other);
  return sum / Shape::points;
}

/// 1 at the nodes of a particle, 0 at all others.
NodeValues nodes_of(const CubePlace& place, ImageIndex image) {
  NodeValues values;
  for (int node = 0; node < Shape::nodes; ++node) values[node] = place.owner(node) == image ? 1.0 : 0.0;
  return values;
}

/// The integrals of the width of a gap, and of its inverse, over the middle of the gap in a cell.
struct GapIntegrals {
  double volume = 0.0, slenderness = 0.0;
};

/// Those of a cell without a facet, as between more than two particles: the middle consists of triangles between the
/// changes of owner on each face, their centre, and the centre of all of them.
GapIntegrals integrals_between_many(const GapGeometry<3>& geometry, const CubePlace& place) {
  struct Change {
    Vector<3> point;
    ImageIndex lower, upper;
  };
  std::vector<std::vector<Change>> by_face(static_cast<std::size_t>(faces_of_cell<3>));
  Vector<3> sum{};
  double found = 0.0;
  for (std::size_t face = 0; face < by_face.size(); ++face) {
    for (std::size_t along = 0; along < 2; ++along) {
      for (const std::size_t from : {std::size_t{0}, std::size_t{2} >> along}) {
        const auto node = node_of_face(face, from);
        const auto axis = axis_of_face(face, along);
        const auto& change = place.changes()[edge_of_cell(node, axis)];
        if (!change) continue;
        const auto lower = static_cast<int>(node);
        const auto at = Shape::corner(lower);
        auto point = place.corner() + Vector<3>{1.0 * at[0], 1.0 * at[1], 1.0 * at[2]};
        point[axis] += *change;
        by_face[face].push_back({point, place.owner(lower), place.owner(CubePlace::beside(lower, axis))});
        sum += point;
        found += 1.0;
      }
    }
  }
  GapIntegrals integrals;
  for (const auto& changes : by_face) {
    Vector<3> centre{};
    for (const auto& change : changes) centre += change.point / static_cast<double>(changes.size());
    for (const auto& [point, lower, upper] : changes) {
      const auto piece =
          make_facet(std::array{point, centre, sum / found}, width_between(geometry.images, lower, upper));
      integrals.volume += piece.volume;
      integrals.slenderness += piece.slenderness;
    }
  }
  return integrals;
}

/// The shares of binder in a cell whose nodes belong to two particles or more: its volume, and a resistance to sliding.
VolumeAndShear binder_in_gap(const GapGeometry<3>& geometry, const CubePlace& place,
                             const std::optional<FacetOfCell>& facet) {
  constexpr double least_slenderness = 1e-3;  // of a facet that hardly enters the cell
  const auto [volume, slenderness] =
      facet ? GapIntegrals{facet->facet.volume, facet->facet.slenderness} : integrals_between_many(geometry, place);
  // The sum over all pairs of the particles, whose nodes are all nodes of the cell.
  double sliding = 0.0;
  for (const auto owner : place.owners()) {
    const auto of_owner = nodes_of(place, owner);
    sliding += 0.5 * mean_product(of_owner, of_owner);
  }
  return {volume, sliding / std::max(slenderness, least_slenderness)};
}

/// The share of binder, for the deviators, of a cell that the surface of one particle crosses: the geometric mean of
/// two shares. One is its volume. With the other one, at most 1, the cell has the work of a constant stress if its free
/// nodes move in proportion to their distances from the particle, as in a layer that is sheared (theory, section 2).
double share_of_layer(const GapGeometry<3>& geometry, const CubePlace& place, ImageIndex image, double binder) {
  NodeValues distances;
  for (int node = 0; node < Shape::nodes; ++node) {
    const auto at = place.node(node);
    const Vector<3> point = {1.0 * at[0], 1.0 * at[1], 1.0 * at[2]};
    distances[node] = std::max(geometry.images.distance(image, point), 0.0);
  }
  if (distances.minCoeff() > 0.0 || distances.maxCoeff() <= rounding) return binder;
  static const auto gradients = gradients_at_points();
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto& gradient : gradients) mean += gradient * distances / Shape::points;
  const double of_work = mean_product(distances, distances) / std::max(mean.norm(), rounding);
  return std::sqrt(binder * std::min(of_work, 1.0));
}

/// Whether a node in binder belongs to a particle.
bool has_owned_binder(const GapGeometry<3>& geometry, const CubePlace& place) {
  for (int node = 0; node < Shape::nodes; ++node) {
    if (place.owner(node) != no_image && geometry.owners.is_in_binder(place.node(node))) return true;
  }
  return false;
}

}  // namespace

CellShares shares_of_cell(const GapGeometry<3>& geometry, const CubePlace& place,
                          const std::optional<FacetOfCell>& facet) {
  std::vector<ParticleShare> particles;
  if (!place.has_free_node()) {
    for (const auto image : place.owners()) {
      const double share = place.owners().size() > 1 ? geometry.images.content(image, place.corner()) + rounding : 1.0;
      particles.push_back(geometry.with_share(image, share, place.corner()));
    }
    const VolumeAndShear binder = place.is_in_gap() ? binder_in_gap(geometry, place, facet) : VolumeAndShear(0.0, 0.0);
    return in_series(geometry.matrix, particles, binder);
  }
  double in_particles = 0.0;
  ImageIndex last = no_image;
  for (const auto image : geometry.images.near(place.centre())) {
    const double share = geometry.images.content(image, place.corner());
    if (share <= rounding) continue;
    particles.push_back(geometry.with_share(image, share, place.corner()));
    in_particles += share;
    last = image;
  }
  const double binder = std::max(1.0 - in_particles, 0.0);
  VolumeAndShear shares(binder, binder);
  if (particles.size() == 1 && !has_owned_binder(geometry, place)) {
    shares[1] = share_of_layer(geometry, place, last, binder);
  }
  return in_series(geometry.matrix, particles, shares);
}

}  // namespace breccia::gaps
