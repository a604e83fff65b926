#include "discretisation/gaps/plane/cell_terms.hpp"

#include <algorithm>
#include <optional>

#include <Eigen/Eigenvalues>

#include "discretisation/gaps/plane/cell_shares.hpp"

namespace breccia::gaps {
namespace {

/// The difference of a displacement component between two nodes, along an axis.
LinearForm<2> difference(int from, int to, std::size_t component) {
  return LinearForm<2>().add(displacement_of<2>(to, component), 1.0).add(displacement_of<2>(from, component), -1.0);
}

/// The slope at a node on walls, whose motion is linear and does not turn: that of the displacement along the face, in
/// the direction of the wall.
LinearForm<2> slope_of_walls(int face, int end) {
  const auto normal = CellPlace::normal(face);
  const int node = CellPlace::node_of(face, end), beside = CellPlace::beside(node, normal);
  return LinearForm<2>().add(CellPlace::is_upper(beside, normal) ? 1.0 : -1.0, difference(node, beside, 1 - normal));
}

/// Whether a node beside the node of a face, along the normal on either side, belongs to its particle.
bool has_own_neighbour(const GapGeometry<2>& geometry, const FacePlace& face, int end) {
  const auto node = face.node(end);
  const auto is_own = [&](int step) {
    auto neighbour = node;
    neighbour[face.normal()] += step;
    return geometry.owners.of(neighbour) == geometry.owners.of(node);
  };
  return is_own(-1) || is_own(1);
}

void tie_slope(const GapGeometry<2>& geometry, const CellPlace& place, int face, int end,
               std::vector<SquareTerm<2>>& terms) {
  const auto normal = CellPlace::normal(face), along = 1 - normal;
  const int node = CellPlace::node_of(face, end), other = CellPlace::node_of(face, 1 - end);
  const int beside = CellPlace::beside(node, normal), beside_other = CellPlace::beside(other, normal);
  const auto owner = place.owner(node);
  const auto slope = LinearForm<2>().add(slope_at(face, end), 1.0);
  // A little stiffness of the binder, so that no cell is without, keeps the slope to that of the face.
  constexpr double little = 0.0005;
  auto of_face = slope;
  of_face.add(-1.0, difference(CellPlace::node_of(face, 0), CellPlace::node_of(face, 1), normal));
  terms.push_back({geometry.matrix, little, of_face});
  if (place.owner(beside) == owner && place.owner(beside_other) == owner) {
    auto form = slope;
    form.add(end == 0 ? -1.0 : 1.0, difference(beside, beside_other, normal));
    terms.push_back({geometry.phase_at_surface(owner), 1.0, form});
    return;
  }
  // Otherwise it has the rotation of the particle, from a neighbour across the cell; zero where neither cell has one.
  auto rotation = slope;
  if (place.owner(beside) == owner) {
    rotation.add(CellPlace::is_upper(beside, normal) ? 1.0 : -1.0, difference(node, beside, along));
  } else if (has_own_neighbour(geometry, place.face_place(face), end)) {
    return;
  }
  terms.push_back({geometry.phase_at_surface(owner), 1.0, rotation});
}

/// A share of the energy of the flow through a face.
void add_flow_through(const GapGeometry<2>& geometry, const CellPlace& place, int face, double share,
                      std::vector<SquareTerm<2>>& terms) {
  if (!place.face(face).has_flow()) return;
  const double unit = place.face(face).unit_of_flow();
  terms.push_back(
      {geometry.matrix, share / place.face(face).conductance, LinearForm<2>().add(flow_through(face), unit)});
}

/// The rotation of a particle from its slopes on the two faces at the ends of a channel; nothing without a slope. Walls
/// close a gap as a particle does that turns the other way than their slopes.
std::optional<LinearForm<2>> rotation_of(const CellPlace& place, const EndsOfChannel& ends, ImageIndex image) {
  LinearForm<2> sum;
  int slopes = 0;
  for (const int face : {ends.begin, ends.end}) {
    for (int end = 0; end < 2; ++end) {
      if (place.owner(CellPlace::node_of(face, end)) != image) continue;
      const double turning = CellPlace::normal(face) == 0 ? -1.0 : 1.0;
      if (image == walls) {
        sum.add(-turning, slope_of_walls(face, end));
      } else if (place.face(face).has_slope[static_cast<std::size_t>(end)]) {
        sum.add(slope_at(face, end), turning);
      } else {
        continue;
      }
      ++slopes;
    }
  }
  if (slopes == 0) return std::nullopt;
  return LinearForm<2>().add(1.0 / slopes, sum);
}

/// Whether a face is on the upper side of its cell.
bool is_upper_face(int face) {
  return face % 2 != 0;
}

}  // namespace

CellUnknowns<2> volume_change(const CellPlace& place) {
  CellUnknowns<2> volume = CellUnknowns<2>::Zero();
  for (int face = 0; face < faces_of_cell<2>; ++face) {
    const double out = is_upper_face(face) ? 1.0 : -1.0;
    const auto& of_face = place.face(face);
    for (int end = 0; end < 2; ++end) {
      const auto number = static_cast<std::size_t>(end);
      volume[displacement_of<2>(CellPlace::node_of(face, end), CellPlace::normal(face))] +=
          out * of_face.of_nodes[number];
      if (of_face.has_slope[number]) volume[slope_at(face, end)] += out * of_face.of_slopes[number];
      if (place.is_on_wall(face, end)) {
        slope_of_walls(face, end).add_to(volume, out * of_face.of_slopes[number]);
      }
    }
    if (of_face.has_flow()) volume[flow_through(face)] -= out * of_face.unit_of_flow();
  }
  return volume;
}

void tie_slopes(const GapGeometry<2>& geometry, const CellPlace& place, std::vector<SquareTerm<2>>& terms) {
  for (int face = 0; face < faces_of_cell<2>; ++face) {
    for (int end = 0; end < 2; ++end) {
      if (place.face(face).has_slope[static_cast<std::size_t>(end)]) tie_slope(geometry, place, face, end, terms);
    }
  }
}

void add_flow(const GapGeometry<2>& geometry, const CellPlace& place, std::vector<SquareTerm<2>>& terms) {
  for (int face = 0; face < faces_of_cell<2>; ++face) add_flow_through(geometry, place, face, 0.5, terms);
}

EndsOfChannel ends_of_channel(const CellPlace& place) noexcept {
  EndsOfChannel ends = {-1, -1};
  for (int face = 0; face < faces_of_cell<2>; ++face) {
    if (place.owner(CellPlace::node_of(face, 0)) == place.owner(CellPlace::node_of(face, 1))) continue;
    (ends.begin < 0 ? ends.begin : ends.end) = face;
  }
  return ends;
}

void add_flow_along(const GapGeometry<2>& geometry, const CellPlace& place, const Channel& channel,
                    std::vector<SquareTerm<2>>& terms) {
  const auto ends = ends_of_channel(place);
  if (!place.face(ends.begin).has_flow() || !place.face(ends.end).has_flow()) {
    add_flow(geometry, place, terms);
    return;
  }
  // A channel without length does not resist; a little of the energy of its faces keeps their flows determined.
  constexpr double little = 1e-4;
  const bool has_length = channel.slenderness > 0.0;
  for (int face = 0; face < faces_of_cell<2>; ++face) {
    const bool is_end = face == ends.begin || face == ends.end;
    if (!is_end) add_flow_through(geometry, place, face, 0.5, terms);
    if (is_end && !has_length) add_flow_through(geometry, place, face, little, terms);
  }
  if (!has_length) return;
  std::array<LinearForm<2>, 3> forms;
  const auto unit_of = [&](int face) { return place.face(face).unit_of_flow(); };
  forms[0].add(flow_through(ends.begin), (is_upper_face(ends.begin) ? -1.0 : 1.0) * unit_of(ends.begin));
  forms[1].add(flow_through(ends.end), (is_upper_face(ends.end) ? 1.0 : -1.0) * unit_of(ends.end));
  const auto first = rotation_of(place, ends, place.owner(0)), second = rotation_of(place, ends, place.second_owner());
  if (first && second) forms[2].add(1.0, *second).add(-1.0, *first);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> modes(channel.resistance);
  for (int mode = 0; mode < 3; ++mode) {
    LinearForm<2> form;
    for (int part = 0; part < 3; ++part) {
      form.add(modes.eigenvectors()(part, mode), forms[static_cast<std::size_t>(part)]);
    }
    terms.push_back({geometry.matrix, std::max(modes.eigenvalues()[mode], 0.0), form});
  }
}

void add_corner_of_particle(const GapGeometry<2>& geometry, const CellPlace& place, std::vector<SquareTerm<2>>& terms) {
  constexpr double least_share = 0.25;
  for (int corner = 0; corner < CellShape<2>::nodes; ++corner) {
    const auto owner = place.owner(corner);
    const int beside = CellPlace::beside(corner, 0), above = CellPlace::beside(corner, 1);
    if (!is_particle(owner) || place.nodes_of(owner) != 3 || place.owner(beside) != owner ||
        place.owner(above) != owner)
      continue;
    const double factor = std::max(share_of(geometry, place, owner), least_share);
    const double to_beside = CellPlace::is_upper(beside, 0) ? 1.0 : -1.0;
    const double to_above = CellPlace::is_upper(above, 1) ? 1.0 : -1.0;
    LinearForm<2> stretch, shear;
    stretch.add(to_beside, difference(corner, beside, 0)).add(-to_above, difference(corner, above, 1));
    shear.add(to_above, difference(corner, above, 0)).add(to_beside, difference(corner, beside, 1));
    terms.push_back({geometry.phase_at_surface(owner), factor, stretch});
    terms.push_back({geometry.phase_at_surface(owner), factor, shear});
  }
}

}  // namespace breccia::gaps
