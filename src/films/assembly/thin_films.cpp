#include "films/assembly/thin_films.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "films/assembly/film_element.hpp"
#include "films/assembly/film_end.hpp"
#include "films/assembly/film_mesh.hpp"
#include "films/assembly/junction_element.hpp"
#include "films/assembly/macroscopic.hpp"
#include "films/assembly/matrix_assembly.hpp"
#include "films/assembly/plane_strain.hpp"
#include "films/assembly/quadratic_triangle.hpp"

namespace breccia::films {
namespace {

/// Adds up the matrices of grains, thin films and junctions.
class ThinFilms {
 public:
  ThinFilms(const FilmMesh& mesh, Boundary boundary)
      : mesh_(mesh),
        network_(mesh.network()),
        meshes_(mesh.grains()),
        boundary_(boundary),
        unknowns_(mesh.unknowns()),
        sum_(unknowns_.count(), unknowns_.pressures()) {}

  void add_grains(const FilmProblem<2>& problem) {
    for (std::size_t g = 0; g < meshes_.size(); ++g) {
      const auto elasticity = elasticity_of_grain(problem, g);
      const auto& positions = meshes_[g].nodes;
      for (const auto& triangle : meshes_[g].triangles) {
        std::vector<NodeImage> nodes;
        nodes.reserve(triangle.size());
        for (const auto node : triangle) nodes.push_back({g, node, Eigen::Vector2i::Zero()});
        const auto functions =
            quadratic_triangle({positions[triangle[0]], positions[triangle[1]], positions[triangle[2]]});
        sum_.add_grain(unknowns_of(nodes, {}), triangle_stiffness(functions, elasticity));
      }
      sum_.add_content_of_grain(films::area(network_.grains[g].corners), elasticity);
    }
  }

  void add_films() {
    const auto lengths = end_lengths(network_);
    for (std::size_t f = 0; f < network_.films.size(); ++f) {
      if (mesh_.is_gap(f)) {
        leave_out(f);
        continue;
      }
      for (int element = 0; element < network_.films[f].segments; ++element) add_stretch(f, element);
      for (std::size_t end = 0; end < 2; ++end) {
        if (!network_.ends_at_wall(f, end)) {
          sum_.add_resistance(flow_at(f, end), mesh_.bend(f, lengths[f][end]));
        } else if (boundary_ == Boundary::traction) {
          add_opening(f, end);
        }
      }
    }
  }

  void add_junctions() {
    for (std::size_t j = 0; j < network_.junctions.size(); ++j) {
      std::vector<Eigen::Vector2d> positions;
      for (const auto& corner : network_.junctions[j].corners) positions.push_back(network_.position(corner));
      const auto element = junction_element(positions);
      const auto unknowns = unknowns_of(mesh_.nodes_of(network_.junctions[j]), {});
      const std::array pressures = {static_cast<int>(j)};
      sum_.add_shear(unknowns, element.shear);
      sum_.add_dilatation(pressures, unknowns, element.dilatation);
      sum_.add_volume(pressures, Eigen::MatrixXd::Constant(1, 1, std::abs(element.area)));
      sum_.add_content(element.area);
    }
  }

  /// Adds uniform tractions on the grains and junctions that the walls cut.
  void add_tractions() {
    for (std::size_t g = 0; g < network_.grains.size(); ++g) {
      for (const auto& edge : network_.grains[g].edges) {
        if (!edge.neighbour && edge.face) add_face_traction(g, *edge.face);
      }
    }
    for (const auto& junction : network_.junctions) {
      if (!junction.is_at_wall) continue;
      const auto force =
          traction_on(network_.position(junction.corners.front()) - network_.position(junction.corners.back()));
      for (const auto& corner : {junction.corners.front(), junction.corners.back()}) {
        add_node_force(mesh_.node_of(corner), 0.5 * force);
      }
    }
  }

  /// Sets the unknowns in a uniform displacement gradient with no displacement at the first node.
  void add_uniform_gradients() {
    const auto& first = meshes_[0].nodes[0];
    for (std::size_t g = 0; g < meshes_.size(); ++g) {
      for (std::size_t n = 0; n < meshes_[g].nodes.size(); ++n) {
        const Eigen::Vector2d position = meshes_[g].nodes[n] - first;
        for (int i = 0; i < 2; ++i) sum_.set_position(unknowns_.displacement(g, n, i), i, position);
      }
    }
    sum_.set_farthest_held(unknowns_.farthest_held() - first);
  }

  [[nodiscard]] FilmMatrices<2> finish() { return sum_.finish(); }

 private:
  /// The unknowns of an element: the displacements of nodes, and flows. The macroscopic motion is relative to the first
  /// node: a translation does no work on an element, and the motion relative to the origin of the box would add its
  /// rounding to the element's forces.
  [[nodiscard]] ElementUnknowns<2> unknowns_of(std::span<const NodeImage> nodes, std::span<const int> flows) const {
    ElementUnknowns<2> unknowns;
    unknowns.macroscopic.setZero(static_cast<Eigen::Index>(2 * nodes.size() + flows.size()), 3);
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      unknowns.macroscopic.middleRows<2>(2 * static_cast<Eigen::Index>(n)) =
          affine_motion(mesh_.position(nodes[n]) - mesh_.position(nodes[0]));
      for (int i = 0; i < 2; ++i) {
        unknowns.numbers.push_back(unknowns_.displacement(nodes[n].grain, nodes[n].number, i));
      }
    }
    unknowns.numbers.insert(unknowns.numbers.end(), flows.begin(), flows.end());
    return unknowns;
  }

  /// Leaves out a film that is a gap, with its pressures and, where it is open, those of the junctions at its ends.
  void leave_out(std::size_t f) {
    for (int element = 0; element < network_.films[f].segments; ++element) {
      for (int end = 0; end < 2; ++end) sum_.isolate(unknowns_.flow(f, element, end));
      for (const int number : unknowns_.pressures(network_, f, element)) {
        const bool is_of_junction = static_cast<std::size_t>(number) < network_.junctions.size();
        if (!is_of_junction || mesh_.is_open(f)) sum_.hold_pressure(number);
      }
    }
  }

  void add_stretch(std::size_t f, int element) {
    const auto matrices = mesh_.element(f, element);
    const std::array flows = {unknowns_.flow(f, element, 0), unknowns_.flow(f, element, 1)};
    const auto unknowns = unknowns_of(mesh_.nodes_of_stretch(f, element), flows);
    const auto pressures = unknowns_.pressures(network_, f, element);
    const auto springs = mesh_.springs(f, element);
    const auto all = with_jumps(unknowns, springs);
    sum_.add_grain(unknowns_of_jumps<2>(springs), springs.stiffness);
    sum_.add_shear(all, stiffness_with_jumps(matrices.shear, springs));
    sum_.add_dilatation(pressures, all, dilatation_with_jumps(matrices.dilatation, springs));
    sum_.add_volume(pressures, matrices.volume);
    sum_.add_content(mesh_.slides(f) ? work_in_uniform_shear(unknowns, matrices.shear) : matrices.volume.sum());
  }

  [[nodiscard]] int flow_at(std::size_t film, std::size_t end) const {
    return end == 0 ? unknowns_.flow(film, 0, 0) : unknowns_.flow(film, network_.films[film].segments - 1, 1);
  }

  /// Adds the stiffness of the opening of a film in a wall under tractions, where the film flows out and the opening
  /// slips along the wall.
  void add_opening(std::size_t f, std::size_t end) {
    const auto& film = network_.films[f];
    const int flow = flow_at(f, end), slip = unknowns_.slip(f, end);
    const auto opening = mesh_.opening(f, end);
    sum_.add_shear({{flow, slip}, Eigen::Matrix<double, 2, 3>::Zero()}, opening.stiffness);
    const double outward = end == 0 ? -1.0 : 1.0;
    sum_.add_outflow(static_cast<int>(film.junctions[end]), flow, outward * film.thickness);
    const auto force = traction_on(mesh_.cut(f, end));
    sum_.add_traction(flow, film.direction.transpose() * force);
    sum_.add_traction(slip, opening.slip.transpose() * force);
  }

  void add_face_traction(std::size_t grain, std::size_t face) {
    constexpr std::array<double, 3> shares = {1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0};
    for (int element = 0; element < network_.segments[grain][face]; ++element) {
      std::array<NodeImage, 3> nodes;
      for (int k = 0; k < 3; ++k) {
        nodes[static_cast<std::size_t>(k)] = {grain, unknowns_.node(grain, face, 2 * element + k),
                                              Eigen::Vector2i::Zero()};
      }
      const auto force = traction_on(mesh_.position(nodes[2]) - mesh_.position(nodes[0]));
      for (std::size_t k = 0; k < 3; ++k) add_node_force(nodes[k], shares[k] * force);
    }
  }

  void add_node_force(const NodeImage& node, const Eigen::Matrix<double, 2, 3>& force) {
    for (int i = 0; i < 2; ++i) {
      sum_.add_traction(unknowns_.displacement(node.grain, node.number, i), force.row(i));
    }
  }

  const FilmMesh& mesh_;
  const FilmNetwork& network_;
  const std::vector<GrainMesh>& meshes_;
  Boundary boundary_;
  const Unknowns& unknowns_;
  MatrixAssembly<2> sum_;
};

}  // namespace

FilmMatrices<2> thin_films(const FilmProblem<2>& problem) {
  const FilmMesh mesh(problem);
  ThinFilms films(mesh, problem.boundary);
  films.add_grains(problem);
  films.add_tractions();
  if (problem.boundary == Boundary::traction) films.add_uniform_gradients();
  films.add_films();
  films.add_junctions();
  return films.finish();
}

}  // namespace breccia::films
