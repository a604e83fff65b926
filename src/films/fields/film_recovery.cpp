#include "films/fields/film_recovery.hpp"

#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "breccia/error.hpp"

#include "films/assembly/film_element.hpp"
#include "films/assembly/film_end.hpp"
#include "films/assembly/film_mesh.hpp"
#include "films/assembly/junction_element.hpp"
#include "films/assembly/macroscopic.hpp"
#include "films/assembly/quadratic_triangle.hpp"

namespace breccia::films {
namespace {

/// The part of the integral of the strain (xx, yy, engineering shear) over a body that comes from the mean displacement
/// of one edge of its boundary, by the theorem of Gauss; the body is on the left of the edge.
Eigen::Vector3d strain_by(const Eigen::Vector2d& stretch, const Eigen::Vector2d& displacement) {
  const Eigen::Vector2d normal(stretch.y(), -stretch.x());
  return {normal.x() * displacement.x(), normal.y() * displacement.y(),
          normal.x() * displacement.y() + normal.y() * displacement.x()};
}

/// Mean of a quadratic function along a line, from its values at the start, middle and end.
template <class Value>
Value mean_of(const Value& begin, const Value& middle, const Value& end) {
  return (begin + 4.0 * middle + end) / 6.0;
}

/// Displacement of a node of an element, from the displacements of all its nodes.
Eigen::Vector2d at_node(const Eigen::VectorXd& displacements, Eigen::Index node) {
  return displacements.segment<2>(2 * node);
}

/// Mean displacements of the two sides of a stretch of film.
std::array<Eigen::Vector2d, 2> means_of_sides(const Eigen::VectorXd& u) {
  return {mean_of(at_node(u, 0), at_node(u, 1), at_node(u, 2)), mean_of(at_node(u, 3), at_node(u, 4), at_node(u, 5))};
}

std::array<double, 3> as_tensor(const Eigen::Vector3d& strain) {
  return {strain[0], strain[1], 0.5 * strain[2]};
}

/// Stress xx, yy, zz, xy from the deviator xx, yy, xy, whose trace is zero, and a pressure.
std::array<double, 4> stress_of(const Eigen::Vector3d& deviator, double pressure) {
  return {deviator[0] - pressure, deviator[1] - pressure, -deviator[0] - deviator[1] - pressure, deviator[2]};
}

/// The fields of one state.
class Recovery {
 public:
  Recovery(const FilmComposite<2>& composite, const FilmProblem<2>& problem, const FilmMesh& mesh, Load load,
           const quasistatic::CompositeState<FilmVector>& state)
      : mesh_(mesh),
        problem_(&problem),
        side_(problem.tessellation.side()),
        boundary_(problem.boundary),
        strain_(strain_of<2>(load)),
        displacement_(&state.displacement),
        shear_(&state.applied[FilmComposite<2>::shear]),
        volumetric_strain_(composite.film_operator().volumetric_strains(load, state.displacement)),
        negative_pressure_(composite.film_operator().volumetric_strains(load, state.applied[FilmComposite<2>::bulk])),
        inflow_(mesh_.network().junctions.size(), Eigen::Vector3d::Zero()) {}

  FilmFields<2> fields() {
    for (std::size_t g = 0; g < mesh_.grains().size(); ++g) add_grain(g);
    const auto ends = end_lengths(mesh_.network());
    for (std::size_t f = 0; f < mesh_.network().films.size(); ++f) add_film(f, ends[f]);
    for (std::size_t j = 0; j < mesh_.network().junctions.size(); ++j) add_junction(j);
    scale_lengths();
    return std::move(fields_);
  }

 private:
  using Motions = std::array<Eigen::Vector2d, 2>;

  /// Converts lengths from sides of the box to metres.
  void scale_lengths() {
    for (auto* vectors : {&fields_.points, &fields_.displacement}) {
      for (auto& [x, y] : *vectors) {
        x *= side_;
        y *= side_;
      }
    }
    for (auto& cell : fields_.cells) {
      cell.content *= side_ * side_;
      for (double* length : {&cell.slip, &cell.opening, &cell.flow}) *length *= side_;
    }
  }

  /// Displacement of a node, with the macroscopic motion relative to the position `from`.
  [[nodiscard]] Eigen::Vector2d displacement_of(const FilmVector& of, const NodeImage& node,
                                                const Eigen::Vector2d& from) const {
    Eigen::Vector2d displacement = of.macroscopic() * affine_motion(mesh_.position(node) - from) * strain_;
    for (int i = 0; i < 2; ++i) {
      const int number = mesh_.unknowns().displacement(node.grain, node.number, i);
      if (number != held) displacement[i] += of.unknowns()[number];
    }
    return displacement;
  }

  /// Displacements of nodes relative to the first of them, two components each, and `others` zeros for the remaining
  /// unknowns of an element.
  [[nodiscard]] Eigen::VectorXd displacements_of(const FilmVector& of, std::span<const NodeImage> nodes,
                                                 Eigen::Index others = 0) const {
    Eigen::VectorXd all = Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(nodes.size()) + others);
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      all.segment<2>(2 * static_cast<Eigen::Index>(n)) = displacement_of(of, nodes[n], mesh_.position(nodes[0]));
    }
    return all;
  }

  std::size_t add_point(const Eigen::Vector2d& position, const Eigen::Vector2d& displacement) {
    fields_.points.push_back({position.x(), position.y()});
    fields_.displacement.push_back({displacement.x(), displacement.y()});
    return fields_.points.size() - 1;
  }

  /// Adds a cell with these nodes as its corners, each with a new point.
  void add_cell(FilmCell<2> cell, std::span<const NodeImage> nodes) {
    for (const auto& node : nodes) {
      const auto displacement = displacement_of(*displacement_, node, Eigen::Vector2d::Zero());
      fields_.corners.push_back(add_point(mesh_.position(node), displacement));
    }
    cell.corners = nodes.size();
    fields_.cells.push_back(cell);
  }

  void add_grain(std::size_t g) {
    const auto& mesh = mesh_.grains()[g];
    std::vector<NodeImage> nodes;
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) nodes.push_back({g, n, Eigen::Vector2i::Zero()});
    const auto displacements = displacements_of(*displacement_, nodes);
    const auto elasticity = elasticity_of_grain(*problem_, g);
    const auto out_of_plane = elasticity_out_of_plane(*problem_, g);
    const Eigen::Vector2d offset = displacement_->macroscopic() * affine_motion(mesh_.position(nodes[0])) * strain_;
    std::vector<std::size_t> points(mesh.nodes.size());
    std::vector<bool> is_added(mesh.nodes.size(), false);
    for (const auto& triangle : mesh.triangles) {
      const auto [at, linear_at, area] =
          quadratic_triangle({mesh.nodes[triangle[0]], mesh.nodes[triangle[1]], mesh.nodes[triangle[2]]});
      Eigen::Matrix<double, 12, 1> u;
      for (std::size_t n = 0; n < triangle.size(); ++n) {
        u.segment<2>(2 * static_cast<Eigen::Index>(n)) =
            displacements.segment<2>(2 * static_cast<Eigen::Index>(triangle[n]));
      }
      FilmCell<2> cell{.part = FilmPart::grain, .corners = 3, .content = area};
      Eigen::Vector3d mean = Eigen::Vector3d::Zero();
      for (const auto& gradients : at) {
        const Eigen::Vector3d strain = strain_rows(gradients) * u;
        mean += strain / 3.0;
        cell.work += strain.dot(elasticity * strain) / 3.0;
      }
      const Eigen::Vector3d stress = elasticity * mean;
      cell.strain = as_tensor(mean);
      cell.stress = {stress[0], stress[1], out_of_plane.dot(mean), stress[2]};
      for (std::size_t n = 0; n < cell.corners; ++n) {
        const auto node = triangle[n];
        if (!is_added[node]) {
          const Eigen::Vector2d displacement = displacements.segment<2>(2 * static_cast<Eigen::Index>(node));
          points[node] = add_point(mesh.nodes[node], displacement + offset);
          is_added[node] = true;
        }
        fields_.corners.push_back(points[node]);
      }
      fields_.cells.push_back(cell);
    }
  }

  [[nodiscard]] double flow(const FilmVector& of, std::size_t film, int element, int end) const {
    return of.unknowns()[mesh_.unknowns().flow(film, element, end)];
  }

  [[nodiscard]] double slip(const FilmVector& of, std::size_t film, std::size_t end) const {
    return of.unknowns()[mesh_.unknowns().slip(film, end)];
  }

  /// Displacements of the binder relative to the mean of the grain faces, at the ends of the elements of a film: the
  /// flow, averaged over the two elements that meet, at a wall under tractions the slip of the opening, and half of the
  /// jump across springs.
  [[nodiscard]] std::vector<Eigen::Vector2d> motions_between(std::size_t f) const {
    const auto& film = mesh_.network().films[f];
    std::vector<Eigen::Vector2d> motions = {flow(*displacement_, f, 0, 0) * film.direction};
    for (int element = 1; element < film.segments; ++element) {
      motions.emplace_back(0.5 * (flow(*displacement_, f, element - 1, 1) + flow(*displacement_, f, element, 0)) *
                           film.direction);
    }
    motions.emplace_back(flow(*displacement_, f, film.segments - 1, 1) * film.direction);
    for (std::size_t end = 0; end < 2; ++end) {
      if (!mesh_.network().ends_at_wall(f, end)) continue;
      auto& motion = end == 0 ? motions.front() : motions.back();
      if (boundary_ == Boundary::displacement) motion.setZero();
      if (boundary_ == Boundary::traction) motion += slip(*displacement_, f, end) * mesh_.opening(f, end).slip;
    }
    for (int element = 0; element < film.segments; ++element) {
      const auto jumps = values_of(*displacement_, mesh_.unknowns().jumps(f, element));
      if (jumps.size() == 0) continue;
      const auto first = static_cast<std::size_t>(element);
      if (element == 0) motions.front() += 0.5 * jumps.head<2>();
      motions[first + 1] += 0.5 * jumps.tail<2>();
    }
    return motions;
  }

  void add_film(std::size_t f, const std::array<double, 2>& end_lengths_of_film) {
    const auto& film = mesh_.network().films[f];
    const auto motions = motions_between(f);
    for (int element = 0; element < film.segments; ++element) {
      const auto first = static_cast<std::size_t>(element);
      add_stretch(f, element, {motions[first], motions[first + 1]}, work_of_ends(f, element, end_lengths_of_film));
    }
    const auto first = mesh_.stretch(f, 0).ends, last = mesh_.stretch(f, film.segments - 1).ends;
    inflow_[film.junctions[0]] -= strain_by(first[1][0] - first[0][0], motions.front());
    inflow_[film.junctions[1]] -= strain_by(last[0][1] - last[1][1], motions.back());
  }

  /// Work of the bends at the ends of a film, and of its openings, in its first and last element.
  [[nodiscard]] double work_of_ends(std::size_t f, int element, const std::array<double, 2>& lengths) const {
    double work = 0.0;
    for (std::size_t end = 0; end < 2; ++end) {
      const int last = end == 0 ? 0 : mesh_.network().films[f].segments - 1;
      if (element != last) continue;
      const auto flow_of = [&](const FilmVector& of) { return flow(of, f, element, static_cast<int>(end)); };
      if (!mesh_.network().ends_at_wall(f, end)) {
        work += mesh_.bend(f, lengths[end]) * flow_of(*displacement_) * flow_of(*shear_);
      } else if (boundary_ == Boundary::traction) {
        const auto both = [&](const FilmVector& of) { return Eigen::Vector2d(flow_of(of), slip(of, f, end)); };
        work += both(*displacement_).dot(mesh_.opening(f, end).stiffness * both(*shear_));
      }
    }
    return work;
  }

  [[nodiscard]] static Eigen::VectorXd values_of(const FilmVector& of, std::span<const int> numbers) {
    Eigen::VectorXd values(std::ssize(numbers));
    for (std::size_t i = 0; i < numbers.size(); ++i) values[static_cast<Eigen::Index>(i)] = of.unknowns()[numbers[i]];
    return values;
  }

  /// Displacements of the nodes of a stretch, its flows and its jumps.
  [[nodiscard]] Eigen::VectorXd unknowns_of_stretch(const FilmVector& of, std::size_t f, int element) const {
    const auto jumps = values_of(of, mesh_.unknowns().jumps(f, element));
    auto all = displacements_of(of, mesh_.nodes_of_stretch(f, element), FilmElement::flows + jumps.size());
    for (int end = 0; end < 2; ++end) all[FilmElement::displacements + end] = flow(of, f, element, end);
    all.tail(jumps.size()) = jumps;
    return all;
  }

  /// Values of a field of the pressure functions (a pressure or a volumetric strain) at the nodes of a stretch.
  [[nodiscard]] Eigen::Vector3d at_pressures(const Eigen::VectorXd& field, std::size_t f, int element) const {
    Eigen::Vector3d values;
    const auto pressures = mesh_.unknowns().pressures(mesh_.network(), f, element);
    for (std::size_t k = 0; k < pressures.size(); ++k) values[static_cast<Eigen::Index>(k)] = field[pressures[k]];
    return values;
  }

  /// The integral of the strain over a stretch whose nodes have the displacements u: the sum over its two sides and its
  /// two ends, at which the binder has the `motions` beyond the mean of the sides.
  [[nodiscard]] Eigen::Vector3d strain_integral(std::span<const NodeImage> nodes, const Eigen::VectorXd& u,
                                                const Motions& motions) const {
    const auto position = [&](std::size_t node) { return mesh_.position(nodes[node]); };
    const auto [first, second] = means_of_sides(u);
    return strain_by(position(0) - position(2), first) + strain_by(position(5) - position(3), second) +
           strain_by(position(3) - position(0), 0.5 * (at_node(u, 0) + at_node(u, 3)) + motions[0]) +
           strain_by(position(2) - position(5), 0.5 * (at_node(u, 2) + at_node(u, 5)) + motions[1]);
  }

  /// Strain, slip, opening and flow of an element of a film of this area.
  [[nodiscard]] FilmCell<2> motion_of_stretch(std::size_t f, int element, const Motions& motions, double area) const {
    const auto& film = mesh_.network().films[f];
    const auto u = unknowns_of_stretch(*displacement_, f, element);
    const auto [first, second] = means_of_sides(u);
    FilmCell<2> cell{.part = mesh_.part(f), .content = area};
    cell.strain = as_tensor(strain_integral(mesh_.nodes_of_stretch(f, element), u, motions) / cell.content);
    cell.slip = (second - first).dot(film.direction);
    cell.opening = (second - first).dot(film.normal);
    cell.flow = 0.5 * (u[FilmElement::displacements] + u[FilmElement::displacements + 1]);
    return cell;
  }

  void add_stretch(std::size_t f, int element, const Motions& motions, double work_of_ends) {
    const auto nodes = mesh_.nodes_of_stretch(f, element);
    const std::array corners = {nodes[2], nodes[0], nodes[3], nodes[5]};
    const auto matrices = mesh_.element(f, element);
    auto cell = motion_of_stretch(f, element, motions, matrices.volume.sum());
    if (mesh_.is_gap(f)) {
      add_cell(cell, corners);
      return;
    }
    const auto u = unknowns_of_stretch(*displacement_, f, element);
    const auto springs = mesh_.springs(f, element);
    const Eigen::VectorXd shear_forces =
        stiffness_with_jumps(matrices.shear, springs) * unknowns_of_stretch(*shear_, f, element);
    const Eigen::VectorXd jumps = u.tail(std::ssize(springs.jumps));
    const double work_of_springs = jumps.dot(springs.stiffness * jumps);
    const auto dilatation = at_pressures(volumetric_strain_, f, element);
    const Eigen::Vector3d bulk_forces = matrices.volume * at_pressures(negative_pressure_, f, element);
    cell.stress = stress_of(mean_deviator(nodes, shear_forces, cell.content), -bulk_forces.sum() / cell.content);
    cell.work = (u.dot(shear_forces) + dilatation.dot(bulk_forces) + work_of_ends + work_of_springs) / cell.content;
    add_cell(cell, corners);
  }

  /// Mean stress of an element, from the work of the forces on its nodes in macroscopic motions.
  [[nodiscard]] Eigen::Vector3d mean_deviator(std::span<const NodeImage> nodes, const Eigen::VectorXd& forces,
                                              double area) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      sum += affine_motion(mesh_.position(nodes[n]) - mesh_.position(nodes[0])).transpose() *
             forces.segment<2>(2 * static_cast<Eigen::Index>(n));
    }
    return sum / area;
  }

  void add_junction(std::size_t j) {
    const auto nodes = mesh_.nodes_of(mesh_.network().junctions[j]);
    if (nodes.size() < 3) return;  // the end of a film at a wall has no area
    std::vector<Eigen::Vector2d> positions;
    positions.reserve(nodes.size());
    for (const auto& node : nodes) positions.push_back(mesh_.position(node));
    const auto element = junction_element(positions);
    const auto u = displacements_of(*displacement_, nodes);
    const Eigen::VectorXd shear_forces = element.shear * displacements_of(*shear_, nodes);
    Eigen::Vector3d strain = inflow_[j];
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      const auto next = (n + 1) % nodes.size();
      strain += strain_by(positions[next] - positions[n], 0.5 * (u.segment<2>(2 * static_cast<Eigen::Index>(n)) +
                                                                 u.segment<2>(2 * static_cast<Eigen::Index>(next))));
    }
    const auto pressure = static_cast<Eigen::Index>(j);
    FilmCell<2> cell{.part = FilmPart::junction, .content = element.area};
    cell.strain = as_tensor(strain / element.area);
    cell.stress = stress_of(mean_deviator(nodes, shear_forces, element.area), -negative_pressure_[pressure]);
    cell.work =
        (u.dot(shear_forces) + std::abs(element.area) * volumetric_strain_[pressure] * negative_pressure_[pressure]) /
        element.area;
    add_cell(cell, nodes);
  }

  const FilmMesh& mesh_;
  const FilmProblem<2>* problem_;
  double side_;
  Boundary boundary_;
  Eigen::Vector3d strain_;
  const FilmVector *displacement_, *shear_;
  Eigen::VectorXd volumetric_strain_, negative_pressure_;  ///< values by number of the pressure
  std::vector<Eigen::Vector3d>
      inflow_;  ///< part of the integral of the strain that comes from flow into a junction, by junction
  FilmFields<2> fields_;
};

}  // namespace

template <>
struct FilmRecovery<2>::Mesh {
  explicit Mesh(const FilmProblem<2>& of) : problem(of), films(problem) {}

  FilmProblem<2> problem;
  FilmMesh films;
};

template <>
FilmRecovery<2>::FilmRecovery(const FilmComposite<2>& composite, const FilmProblem<2>& problem)
    : composite_(&composite) {
  if (problem.layers) throw InputError("films: there are no fields of resolved films, only of thin ones");
  mesh_ = std::make_shared<const Mesh>(problem);
}

template <>
FilmFields<2> FilmRecovery<2>::fields(Load load, const quasistatic::CompositeState<FilmVector>& state) const {
  return Recovery(*composite_, mesh_->problem, mesh_->films, load, state).fields();
}

}  // namespace breccia::films
