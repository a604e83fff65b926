#include "films/assembly/resolved_films.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "films/assembly/macroscopic.hpp"
#include "films/assembly/matrix_assembly.hpp"
#include "films/assembly/mixed_element.hpp"
#include "films/assembly/plane_strain.hpp"
#include "films/assembly/quadratic_triangle.hpp"
#include "films/mesh/resolved_mesh.hpp"

namespace breccia::films {
namespace {

/// Whether two positions are on the same wall of the box.
bool are_on_a_wall(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  constexpr double tolerance = 1e-10;
  const auto is_at = [&](int axis, double wall) {
    return std::abs(a[axis] - wall) < tolerance && std::abs(b[axis] - wall) < tolerance;
  };
  return is_at(0, 0.0) || is_at(0, 1.0) || is_at(1, 0.0) || is_at(1, 1.0);
}

/// Numbers of the unknowns: the displacements of all nodes, and the pressures at the corners of the elements of the
/// binder. Boundaries hold the same displacements as with thin films (see Unknowns).
class ResolvedUnknowns {
 public:
  ResolvedUnknowns(const ResolvedMesh& mesh, Boundary boundary)
      : displacements_(2 * mesh.nodes.size(), 0), pressures_(mesh.nodes.size(), none) {
    if (boundary == Boundary::displacement) {
      for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
        if (are_on_a_wall(mesh.nodes[n], mesh.nodes[n])) displacements_[2 * n] = displacements_[2 * n + 1] = held;
      }
    } else {
      displacements_[0] = displacements_[1] = held;
    }
    if (boundary == Boundary::traction) hold_rotation(mesh);
    for (int& number : displacements_) {
      if (number != held) number = count_++;
    }
    for (const auto& element : mesh.quadrilaterals) number_pressures(element);
    for (const auto& element : mesh.triangles) number_pressures(element);
  }

  [[nodiscard]] int count() const noexcept { return count_; }
  [[nodiscard]] int pressures() const noexcept { return pressure_count_; }
  [[nodiscard]] int displacement(std::size_t node, int component) const noexcept {
    return displacements_[2 * node + static_cast<std::size_t>(component)];
  }
  [[nodiscard]] int pressure(std::size_t node) const noexcept { return pressures_[node]; }
  [[nodiscard]] std::size_t farthest_held() const noexcept { return farthest_held_; }

 private:
  static constexpr int none = -1;

  /// Holds the second displacement component of the node that is farthest from the first one along the first axis.
  void hold_rotation(const ResolvedMesh& mesh) {
    const auto distance = [&](std::size_t node) { return std::abs(mesh.nodes[node].x() - mesh.nodes[0].x()); };
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
      if (distance(n) > distance(farthest_held_)) farthest_held_ = n;
    }
    displacements_[2 * farthest_held_ + 1] = held;
  }

  template <std::size_t corners, std::size_t count>
  void number_pressures(const MeshElement<corners, count>& element) {
    for (std::size_t c = 0; c < corners; ++c) {
      int& number = pressures_[element.nodes[c]];
      if (number == none) number = pressure_count_++;
    }
  }

  std::vector<int> displacements_;  ///< numbers by node and component
  std::vector<int> pressures_;      ///< numbers by node
  std::size_t farthest_held_ = 0;
  int count_ = 0, pressure_count_ = 0;
};

/// Positions of all nodes of an element: its corners, the middles of its edges, and its centre if it has one.
template <std::size_t corners, std::size_t count>
std::array<Eigen::Vector2d, count> positions_of(const MeshElement<corners, count>& element) {
  std::array<Eigen::Vector2d, count> positions;
  positions.back().setZero();
  for (std::size_t c = 0; c < corners; ++c) {
    positions[c] = element.positions[c];
    positions[corners + c] = 0.5 * (element.positions[c] + element.positions[(c + 1) % corners]);
  }
  if constexpr (count > 2 * corners) {
    for (const auto& corner : element.positions) positions.back() += corner / static_cast<double>(corners);
  }
  return positions;
}

/// Adds up the matrices of the elements of a mesh.
class ResolvedFilms {
 public:
  ResolvedFilms(const ResolvedMesh& mesh, Boundary boundary)
      : mesh_(mesh), unknowns_(mesh, boundary), sum_(unknowns_.count(), unknowns_.pressures()) {}

  void add_grains(const FilmProblem<2>& problem) {
    for (std::size_t e = 0; e < mesh_.grains.size(); ++e) {
      const auto elasticity = elasticity_of_grain(problem, mesh_.grain_of_element[e]);
      const auto triangle = quadratic_triangle(mesh_.grains[e].positions);
      sum_.add_grain(unknowns_of(mesh_.grains[e]), triangle_stiffness(triangle, elasticity));
      sum_.add_content_of_grain(triangle.area, elasticity);
    }
  }

  void add_binder() {
    for (const auto& element : mesh_.quadrilaterals) add_mixed(element, mixed_quadrilateral(element.positions));
    for (const auto& element : mesh_.triangles) add_mixed(element, mixed_triangle(element.positions));
  }

  /// Adds uniform tractions on the edges along the walls.
  void add_tractions() {
    for (const auto& element : mesh_.grains) add_tractions(element);
    for (const auto& element : mesh_.quadrilaterals) add_tractions(element);
    for (const auto& element : mesh_.triangles) add_tractions(element);
  }

  /// Sets the unknowns in a uniform displacement gradient with no displacement at the first node.
  void add_uniform_gradients() {
    const auto& first = mesh_.nodes[0];
    for (std::size_t n = 0; n < mesh_.nodes.size(); ++n) {
      for (int i = 0; i < 2; ++i) sum_.set_position(unknowns_.displacement(n, i), i, mesh_.nodes[n] - first);
    }
    sum_.set_farthest_held(mesh_.nodes[unknowns_.farthest_held()] - first);
  }

  [[nodiscard]] FilmMatrices<2> finish() { return sum_.finish(); }

 private:
  /// The displacements of the nodes of an element; the macroscopic motion is relative to its first node, as for thin
  /// films.
  template <std::size_t corners, std::size_t count>
  [[nodiscard]] ElementUnknowns<2> unknowns_of(const MeshElement<corners, count>& element) const {
    ElementUnknowns<2> unknowns;
    unknowns.macroscopic.resize(static_cast<Eigen::Index>(2 * count), 3);
    const auto positions = positions_of(element);
    for (std::size_t n = 0; n < count; ++n) {
      unknowns.macroscopic.template middleRows<2>(2 * static_cast<Eigen::Index>(n)) =
          affine_motion(positions[n] - positions[0]);
      for (int i = 0; i < 2; ++i) unknowns.numbers.push_back(unknowns_.displacement(element.nodes[n], i));
    }
    return unknowns;
  }

  template <std::size_t corners, std::size_t count>
  void add_mixed(const MeshElement<corners, count>& element, const MixedElement& matrices) {
    const auto unknowns = unknowns_of(element);
    std::array<int, corners> pressures{};
    for (std::size_t c = 0; c < corners; ++c) pressures[c] = unknowns_.pressure(element.nodes[c]);
    sum_.add_shear(unknowns, matrices.shear);
    sum_.add_dilatation(pressures, unknowns, matrices.dilatation);
    sum_.add_volume(pressures, matrices.volume);
    sum_.add_content(matrices.volume.sum());
  }

  template <std::size_t corners, std::size_t count>
  void add_tractions(const MeshElement<corners, count>& element) {
    for (std::size_t c = 0; c < corners; ++c) {
      const std::size_t next = (c + 1) % corners;
      if (!are_on_a_wall(element.positions[c], element.positions[next])) continue;
      const auto force = traction_on(element.positions[next] - element.positions[c]);
      add_node_force(element.nodes[c], 1.0 / 6.0 * force);
      add_node_force(element.nodes[corners + c], 4.0 / 6.0 * force);
      add_node_force(element.nodes[next], 1.0 / 6.0 * force);
    }
  }

  void add_node_force(std::size_t node, const Eigen::Matrix<double, 2, 3>& force) {
    for (int i = 0; i < 2; ++i) sum_.add_traction(unknowns_.displacement(node, i), force.row(i));
  }

  const ResolvedMesh& mesh_;
  ResolvedUnknowns unknowns_;
  MatrixAssembly<2> sum_;
};

}  // namespace

FilmMatrices<2> resolved_films(const FilmProblem<2>& problem) {
  const auto mesh = resolved_mesh(problem);
  ResolvedFilms films(mesh, problem.boundary);
  films.add_grains(problem);
  films.add_binder();
  if (problem.boundary == Boundary::traction) {
    films.add_tractions();
    films.add_uniform_gradients();
  }
  return films.finish();
}

}  // namespace breccia::films
