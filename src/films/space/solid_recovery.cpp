#include "films/space/solid_recovery.hpp"

#include <array>
#include <cstddef>
#include <map>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "breccia/error.hpp"

#include "films/assembly/macroscopic.hpp"
#include "films/assembly/matrix_assembly.hpp"
#include "films/space/film_wedge.hpp"
#include "films/space/solid_elements.hpp"
#include "films/space/solid_strain.hpp"
#include "films/space/solid_unknowns.hpp"
#include "films/space/space_mesh.hpp"

namespace breccia::films {
namespace {

using Tensor = Eigen::Matrix<double, 6, 1>;  ///< xx, yy, zz, yz, zx, xy

/// A strain in Voigt's order, with engineering shears, as a tensor.
std::array<double, 6> as_tensor(const Tensor& strain) {
  return {strain[0], strain[1], strain[2], 0.5 * strain[3], 0.5 * strain[4], 0.5 * strain[5]};
}

std::array<double, 6> as_array(const Tensor& stress) {
  return {stress[0], stress[1], stress[2], stress[3], stress[4], stress[5]};
}

/// The stress of a deviator and a pressure.
std::array<double, 6> stress_of(Tensor deviator, double pressure) {
  deviator.head<3>().array() -= pressure;
  return as_array(deviator);
}

/// The part of the integral of the strain over a body that comes from a piece of its boundary, by the theorem of Gauss;
/// `displacement` is the integral of the displacement times the outward normal, u n^T.
Tensor strain_by(const Eigen::Matrix3d& displacement) {
  return {displacement(0, 0),
          displacement(1, 1),
          displacement(2, 2),
          displacement(1, 2) + displacement(2, 1),
          displacement(2, 0) + displacement(0, 2),
          displacement(0, 1) + displacement(1, 0)};
}

/// The integral of the product of two linear functions over an interval of length 1, from their values at its ends.
Eigen::Vector3d integral_of_product(const std::array<double, 2>& factor, const std::array<Eigen::Vector3d, 2>& value) {
  return (factor[0] * (2.0 * value[0] + value[1]) + factor[1] * (value[0] + 2.0 * value[1])) / 6.0;
}

/// A corner of a triangle of a film halfway between both sides.
struct MiddleCorner {
  Eigen::Vector3d position;
  double thickness = 0.0;
  Eigen::Vector3d flow;  ///< mean displacement of the binder relative to the mean of both sides
};

/// A triangle of a film halfway between both sides.
struct MiddleTriangle {
  Eigen::Vector3d normal;  ///< from the first side to the second one, of length 1
  std::array<MiddleCorner, 3> corners;
  std::array<Eigen::Vector3d, 6> jumps;  ///< at its nodes; zero without springs

  /// The number of a corner after a whole turn is that of the first one.
  [[nodiscard]] const MiddleCorner& corner(int number) const { return corners[static_cast<std::size_t>(number % 3)]; }

  /// The integral of the thickness times the jump along an edge whose length counts as 1, by Simpson's rule.
  [[nodiscard]] Eigen::Vector3d integral_of_jumps(int edge) const {
    const auto begin = static_cast<std::size_t>(edge), end = (begin + 1) % 3, between = begin + 3;
    const double of_begin = corners[begin].thickness, of_end = corners[end].thickness;
    return (of_begin * jumps[begin] + 2.0 * (of_begin + of_end) * jumps[between] + of_end * jumps[end]) / 6.0;
  }
};

/// An edge of a triangle of a film: the face, and the number and the image of the node in its middle.
using EdgeKey = std::tuple<std::size_t, std::size_t, std::array<int, 3>>;

EdgeKey key_of(const SheetTriangle& triangle, int edge) {
  const auto& [number, image] = triangle.nodes[3 + static_cast<std::size_t>(edge)];
  return {triangle.face, number, {image.x(), image.y(), image.z()}};
}

/// Grains, films and channels, and what is beside the edges of the triangles of the films.
struct FieldMesh {
  explicit FieldMesh(const FilmProblem<3>& problem) : pieces(problem) {
    for (std::size_t t = 0; t < pieces.sheets().triangles.size(); ++t) {
      const auto& triangle = pieces.sheets().triangles[t];
      for (int edge = 0; edge < 3; ++edge) edges.emplace(key_of(triangle, edge), std::pair(t, edge));
    }
    for (std::size_t s = 0; s < pieces.sheets().segments.size(); ++s) {
      segment[pieces.sheets().segments[s].nodes[1].number] = s;
    }
  }

  SpaceMesh pieces;
  std::multimap<EdgeKey, std::pair<std::size_t, int>> edges;  ///< triangles and their edges, one or two by edge
  std::map<std::size_t, std::size_t> segment;                 ///< segment of a channel by the node in its middle
};

/// The fields of one state.
class Recovery {
 public:
  Recovery(const FilmComposite<3>& composite, const FilmProblem<3>& problem, const FieldMesh& mesh, Load load,
           const quasistatic::CompositeState<FilmVector>& state)
      : edges_(mesh.edges),
        segment_(mesh.segment),
        mesh_(mesh.pieces),
        problem_(&problem),
        side_(problem.tessellation.side()),
        strain_(strain_of<3>(load)),
        displacement_(&state.displacement),
        shear_(&state.applied[FilmComposite<3>::shear]),
        volumetric_strain_(composite.film_operator().volumetric_strains(load, state.displacement)),
        negative_pressure_(composite.film_operator().volumetric_strains(load, state.applied[FilmComposite<3>::bulk])),
        inflow_(mesh_.sheets().segments.size(), Tensor::Zero()) {}

  FilmFields<3> fields() {
    for (std::size_t g = 0; g < mesh_.grains().solids().size(); ++g) add_grain(g);
    for (std::size_t t = 0; t < mesh_.sheets().triangles.size(); ++t) add_film(t);
    for (std::size_t s = 0; s < mesh_.sheets().segments.size(); ++s) {
      const auto& nodes = mesh_.sheets().segments[s].nodes;
      const auto of_grains = mesh_.nodes_of_channel(s);
      add_binder(FilmPart::channel, of_grains, channel_element(mesh_.channel(s)), nodes, inflow_[s],
                 std::array{of_grains[2], of_grains[5], of_grains[8], of_grains[0], of_grains[3], of_grains[6]});
    }
    for (std::size_t p = 0; p < mesh_.sheets().points.size(); ++p) {
      const auto of_grains = mesh_.nodes_of_corner(p);
      add_binder(FilmPart::junction, of_grains, corner_element(mesh_.corner(p)),
                 std::span(&mesh_.sheets().points[p], 1), Tensor::Zero(), of_grains);
    }
    scale_lengths();
    return std::move(fields_);
  }

 private:
  /// Converts lengths from sides of the box to metres.
  void scale_lengths() {
    for (auto* vectors : {&fields_.points, &fields_.displacement}) {
      for (auto& vector : *vectors) {
        for (double& component : vector) component *= side_;
      }
    }
    for (auto& cell : fields_.cells) {
      cell.content *= side_ * side_ * side_;
      for (double* length : {&cell.slip, &cell.opening, &cell.flow}) *length *= side_;
    }
  }

  /// The values of the unknowns of an element, displacements relative to its first node.
  [[nodiscard]] Eigen::VectorXd values_of(const ElementUnknowns<3>& unknowns, const FilmVector& of) const {
    Eigen::VectorXd values = of.macroscopic() * unknowns.macroscopic * strain_;
    for (std::size_t i = 0; i < unknowns.numbers.size(); ++i) {
      if (unknowns.numbers[i] != held) values[static_cast<Eigen::Index>(i)] += of.unknowns()[unknowns.numbers[i]];
    }
    return values;
  }

  [[nodiscard]] std::size_t add_point(const SolidNode& node) {
    const auto position = mesh_.grains().position(node);
    Eigen::Vector3d displacement = displacement_->macroscopic() * affine_motion_in_space(position) * strain_;
    const int number = mesh_.number(node);
    if (number != 0) displacement += displacement_->unknowns().segment<3>(displacements_of(number));
    fields_.points.push_back({position.x(), position.y(), position.z()});
    fields_.displacement.push_back({displacement.x(), displacement.y(), displacement.z()});
    return fields_.points.size() - 1;
  }

  /// Adds a cell with these nodes as its corners, each with a new point.
  void add_cell(FilmCell<3> cell, std::span<const SolidNode> nodes) {
    for (const auto& node : nodes) fields_.corners.push_back(add_point(node));
    cell.corners = nodes.size();
    fields_.cells.push_back(cell);
  }

  void add_grain(std::size_t g) {
    const auto& solid = mesh_.grains().solids()[g];
    const auto elasticity = elasticity_of_grain(*problem_, g);
    std::map<std::size_t, std::size_t> point_of;
    for (const auto& tetrahedron : solid.tetrahedra) {
      std::vector<SolidNode> nodes;
      nodes.reserve(tetrahedron.size());
      for (const auto node : tetrahedron) nodes.push_back({g, node, Eigen::Vector3i::Zero()});
      const std::array corners = {solid.nodes[tetrahedron[0]], solid.nodes[tetrahedron[1]], solid.nodes[tetrahedron[2]],
                                  solid.nodes[tetrahedron[3]]};
      const auto u = values_of(mesh_.unknowns_of(nodes), *displacement_);
      FilmCell<3> cell{.part = FilmPart::grain, .corners = corners.size(), .content = volume_of(corners)};
      const Tensor strain = tetrahedron_strain(corners) * u / cell.content;
      cell.strain = as_tensor(strain);
      cell.stress = as_array(elasticity * strain);
      cell.work = u.dot(tetrahedron_stiffness(corners, elasticity) * u) / cell.content;
      for (std::size_t corner = 0; corner < corners.size(); ++corner) {
        const auto [found, is_new] = point_of.try_emplace(tetrahedron[corner]);
        if (is_new) found->second = add_point(nodes[corner]);
        fields_.corners.push_back(found->second);
      }
      fields_.cells.push_back(cell);
    }
  }

  /// A cell of binder with its content and its strain; `flow` is the part of the integral of the strain that comes from
  /// a flow. A cell without content has no strain.
  template <class Element>
  [[nodiscard]] FilmCell<3> strained_cell(FilmPart part, const ElementUnknowns<3>& unknowns, const Element& element,
                                          const Tensor& flow) const {
    const auto displacements = element.strain.cols();
    FilmCell<3> cell{.part = part};
    cell.content = element.strain.row(0).dot(unknowns.macroscopic.col(0).head(displacements));
    if (cell.content == 0.0) return cell;
    const Eigen::VectorXd u = values_of(unknowns, *displacement_).head(displacements);
    cell.strain = as_tensor((element.strain * u + flow) / cell.content);
    return cell;
  }

  /// Values of a field of the pressure functions (a pressure or a volumetric strain) at nodes.
  [[nodiscard]] static Eigen::VectorXd at_nodes(const Eigen::VectorXd& field, std::span<const SheetNode> nodes) {
    Eigen::VectorXd values(static_cast<Eigen::Index>(nodes.size()));
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      values[static_cast<Eigen::Index>(i)] = field[static_cast<Eigen::Index>(nodes[i].number)];
    }
    return values;
  }

  /// Sets the stress and the work of a cell of binder with these unknowns and pressures.
  void set_stress(FilmCell<3>& cell, const ElementUnknowns<3>& unknowns, const Eigen::MatrixXd& shear,
                  const Eigen::MatrixXd& volume, std::span<const SheetNode> pressures) const {
    if (cell.content == 0.0) return;
    const Eigen::VectorXd forces = shear * values_of(unknowns, *shear_);
    const Eigen::VectorXd bulk_forces = volume * at_nodes(negative_pressure_, pressures);
    const Tensor deviator = unknowns.macroscopic.transpose() * forces / cell.content;
    cell.stress = stress_of(deviator, -bulk_forces.sum() / cell.content);
    cell.work =
        (values_of(unknowns, *displacement_).dot(forces) + at_nodes(volumetric_strain_, pressures).dot(bulk_forces)) /
        cell.content;
  }

  /// Adds a channel or a junction; `flow` is the part of the integral of its strain that comes from flows into it.
  void add_binder(FilmPart part, std::span<const SolidNode> nodes, const BinderElement& element,
                  std::span<const SheetNode> pressures, const Tensor& flow, std::span<const SolidNode> corners) {
    const auto unknowns = mesh_.unknowns_of(nodes);
    auto cell = strained_cell(part, unknowns, element, flow);
    set_stress(cell, unknowns, element.shear, element.volume, pressures);
    add_cell(cell, corners);
  }

  [[nodiscard]] MiddleTriangle middle_of(std::size_t triangle) const {
    const auto wedge = mesh_.film(triangle);
    const auto& [first, second] = wedge.triangles;
    const auto axes = film_axes(wedge);
    MiddleTriangle middle;
    middle.normal = axes.col(0).cross(axes.col(1));
    for (std::size_t k = 0; k < first.size(); ++k) {
      const auto flow = displacement_->unknowns().segment<2>(mesh_.flows_of(triangle)[2 * k]);
      middle.corners[k] = {0.5 * (first[k] + second[k]), (second[k] - first[k]).dot(middle.normal), axes * flow};
    }
    middle.jumps.fill(Eigen::Vector3d::Zero());
    const auto& jumps = mesh_.jumps(triangle);
    for (std::size_t node = 0; 3 * node < jumps.size(); ++node) {
      middle.jumps[node] = displacement_->unknowns().segment<3>(jumps[3 * node]);
    }
    return middle;
  }

  /// The part of the integral of the strain over a triangle of a film that comes from the flow through its edges. At an
  /// edge between two triangles the flow is the mean of theirs; what leaves at a rim enters the channel there.
  [[nodiscard]] Tensor strain_by_flow(std::size_t triangle) {
    const auto& element = mesh_.sheets().triangles[triangle];
    const auto middle = middle_of(triangle);
    Tensor sum = Tensor::Zero();
    for (int edge = 0; edge < 3; ++edge) {
      const auto &begin = middle.corner(edge), &end = middle.corner(edge + 1);
      std::array flows = {begin.flow, end.flow};
      const auto [low, high] = edges_.equal_range(key_of(element, edge));
      for (auto other = low; other != high; ++other) {
        const auto [neighbour, number] = other->second;
        if (neighbour == triangle) continue;
        // The neighbour passes the edge in the other direction.
        const auto beyond = middle_of(neighbour);
        flows = {0.5 * (flows[0] + beyond.corner(number + 1).flow), 0.5 * (flows[1] + beyond.corner(number).flow)};
      }
      const Eigen::Vector3d outward = (end.position - begin.position).cross(middle.normal);
      const Eigen::Vector3d integral =
          integral_of_product({begin.thickness, end.thickness}, flows) + 0.5 * middle.integral_of_jumps(edge);
      const Tensor strain = strain_by(integral * outward.transpose());
      sum += strain;
      constexpr int rim = 1;
      if (element.is_at_rim && edge == rim) inflow_[segment_.at(std::get<1>(key_of(element, edge)))] -= strain;
    }
    return sum;
  }

  void add_film(std::size_t t) {
    const auto nodes = mesh_.nodes_of_film(t);
    const auto unknowns = mesh_.unknowns_of(nodes, mesh_.flows_of(t));
    const auto wedge = mesh_.film(t);
    const auto& triangle = mesh_.sheets().triangles[t];
    const auto part = part_of_film(mesh_.debonding(t));
    const auto element =
        part == FilmPart::slip ? sliding_film_wedge(wedge, triangle.is_at_rim) : film_wedge(wedge, triangle.is_at_rim);
    auto cell = strained_cell(part, unknowns, element, strain_by_flow(t));
    set_motion(cell, values_of(unknowns, *displacement_), element.axes);
    if (part != FilmPart::gap) {
      const auto springs = mesh_.springs(t);
      const auto shear = stiffness_with_jumps(element.shear, springs);
      set_stress(cell, with_jumps(unknowns, springs), shear, element.volume, triangle.nodes);
      const auto jumps = values_of(unknowns_of_jumps<3>(springs), *displacement_);
      if (cell.content != 0.0) cell.work += jumps.dot(springs.stiffness * jumps) / cell.content;
    }
    // A wedge of VTK begins with the triangle that is counter-clockwise from outside.
    add_cell(cell, std::array{nodes[6], nodes[7], nodes[8], nodes[0], nodes[1], nodes[2]});
  }

  /// Sets slip, opening and flow of a triangle of a film whose unknowns have these values.
  static void set_motion(FilmCell<3>& cell, const Eigen::VectorXd& u, const Eigen::Matrix<double, 3, 2>& axes) {
    Eigen::Vector3d relative = Eigen::Vector3d::Zero();
    Eigen::Vector2d flow = Eigen::Vector2d::Zero();
    // The mean of a quadratic function over a triangle is that of its values in the middles of the edges.
    for (int k = 0; k < 3; ++k) {
      constexpr int second_side = 18, first_middle = 9;
      const int middle = first_middle + 3 * k;
      relative += (u.segment<3>(second_side + middle) - u.segment<3>(middle)) / 3.0;
      flow += u.segment<2>(FilmWedge::displacements + 2 * k) / 3.0;
    }
    cell.slip = (axes.transpose() * relative).norm();
    cell.opening = axes.col(0).cross(axes.col(1)).dot(relative);
    cell.flow = flow.norm();
  }

  const std::multimap<EdgeKey, std::pair<std::size_t, int>>& edges_;
  const std::map<std::size_t, std::size_t>& segment_;
  const SpaceMesh& mesh_;
  const FilmProblem<3>* problem_;
  double side_;
  Tensor strain_;
  const FilmVector *displacement_, *shear_;
  Eigen::VectorXd volumetric_strain_, negative_pressure_;  ///< values by node of the sheets
  std::vector<Tensor> inflow_;  ///< part of the integral of the strain that comes from flow into a channel, by segment
  FilmFields<3> fields_;
};

}  // namespace

template <>
struct FilmRecovery<3>::Mesh {
  explicit Mesh(const FilmProblem<3>& of) : problem(of), films(problem) {}

  FilmProblem<3> problem;
  FieldMesh films;
};

template <>
FilmRecovery<3>::FilmRecovery(const FilmComposite<3>& composite, const FilmProblem<3>& problem)
    : composite_(&composite) {
  if (problem.layers) throw InputError("films: there are no fields of resolved films, only of thin ones");
  mesh_ = std::make_shared<const Mesh>(problem);
}

template <>
FilmFields<3> FilmRecovery<3>::fields(Load load, const quasistatic::CompositeState<FilmVector>& state) const {
  return Recovery(*composite_, mesh_->problem, mesh_->films, load, state).fields();
}

}  // namespace breccia::films
