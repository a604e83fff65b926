#include "assembly/film_operator.hpp"

#include <array>
#include <span>

#include "breccia/error.hpp"

#include "assembly/film_element.hpp"
#include "assembly/film_end.hpp"
#include "assembly/film_mesh.hpp"
#include "assembly/grain_stiffness.hpp"
#include "assembly/junction_element.hpp"
#include "assembly/macroscopic.hpp"

namespace breccia::films {
namespace {

/// Components of the unit stress of a load: xx, yy, xy.
Eigen::Vector3d stress_of(Load load) {
  const auto stress = unit_stress<2>(load);
  return {stress.xx, stress.yy, stress.xy};
}

/// Force on a line by the stresses xx, yy and xy; `line` has the body on its left.
Eigen::Matrix<double, 2, 3> traction_on(const Eigen::Vector2d& line) {
  const Eigen::Vector2d normal(line.y(), -line.x());
  Eigen::Matrix<double, 2, 3> force;
  force << normal.x(), 0.0, normal.y(), 0.0, normal.y(), normal.x();
  return force;
}

/// Unknowns of an element: their numbers, and what each of them is by the macroscopic strains.
struct ElementUnknowns {
  std::vector<int> numbers;
  Eigen::Matrix<double, Eigen::Dynamic, 3> macroscopic;
};

}  // namespace

/// Adds up the matrices of all elements.
class FilmOperator::Assembly {
 public:
  Assembly(FilmOperator& result, const FilmMesh& mesh)
      : result_(result), mesh_(mesh), network_(mesh.network()), meshes_(mesh.grains()), unknowns_(mesh.unknowns()) {}

  void add_grains(const Moduli& moduli) {
    for (std::size_t g = 0; g < meshes_.size(); ++g) {
      std::vector<NodeImage> nodes;
      for (std::size_t n = 0; n < meshes_[g].boundary_nodes; ++n) nodes.push_back({g, n, Eigen::Vector2i::Zero()});
      add_symmetric(grains_, unknowns_of(nodes, {}), grain_stiffness(meshes_[g], moduli));
      result_.area_ += films::area(network_.grains[g].corners);
    }
  }

  void add_films() {
    const auto lengths = end_lengths(network_);
    for (std::size_t f = 0; f < network_.films.size(); ++f) {
      for (int element = 0; element < network_.films[f].segments; ++element) add_stretch(f, element);
      for (int end = 0; end < 2; ++end) add_end(f, end, lengths[f][static_cast<std::size_t>(end)]);
    }
  }

  void add_junctions() {
    for (std::size_t j = 0; j < network_.junctions.size(); ++j) {
      std::vector<Eigen::Vector2d> places;
      for (const auto& corner : network_.junctions[j].corners) places.push_back(network_.place(corner));
      const auto element = junction_element(places);
      const auto unknowns = unknowns_of(mesh_.nodes_of(network_.junctions[j]), {});
      const int pressure = static_cast<int>(j);
      add_symmetric(shear_, unknowns, element.shear);
      add_dilatation(std::array{pressure}, unknowns, element.dilatation);
      volume_.emplace_back(pressure, pressure, std::abs(element.area));
      result_.area_ += element.area;
    }
  }

  /// Uniform tractions on what is cut by the walls.
  void add_tractions() {
    result_.tractions_.setZero(unknowns_.count(), 3);
    for (std::size_t g = 0; g < network_.grains.size(); ++g) {
      for (const auto& edge : network_.grains[g].edges) {
        if (!edge.neighbour && edge.face) add_face_traction(g, *edge.face);
      }
    }
    for (const auto& junction : network_.junctions) {
      if (!junction.is_at_wall) continue;
      const auto force =
          traction_on(network_.place(junction.corners.front()) - network_.place(junction.corners.back()));
      for (const auto& corner : {junction.corners.front(), junction.corners.back()}) {
        add_node_force(mesh_.node_of(corner), 0.5 * force);
      }
    }
  }

  /// What the unknowns are in a uniform displacement gradient that leaves the first node where it is.
  void add_uniform_gradients() {
    result_.by_gradient_.setZero(unknowns_.count(), 4);
    const auto& first = meshes_[0].nodes[0];
    for (std::size_t g = 0; g < meshes_.size(); ++g) {
      for (std::size_t n = 0; n < meshes_[g].boundary_nodes; ++n) {
        const Eigen::Vector2d place = meshes_[g].nodes[n] - first;
        for (int i = 0; i < 2; ++i) {
          const int number = unknowns_.displacement(g, n, i);
          if (number != Unknowns::held) result_.by_gradient_.row(number).segment<2>(2 * i) = place.transpose();
        }
      }
    }
    result_.held_ = unknowns_.farthest_held() - first;
  }

  void finish() {
    const int all = unknowns_.count() + macroscopic, pressures = unknowns_.pressures();
    const auto make = [](Sparse& matrix, int rows, int columns, std::vector<Eigen::Triplet<double>>& entries) {
      matrix.resize(rows, columns);
      matrix.setFromTriplets(entries.begin(), entries.end());
      entries = {};
    };
    make(result_.grains_, all, all, grains_);
    make(result_.shear_, all, all, shear_);
    make(result_.dilatation_, pressures, all, dilatation_);
    make(result_.volume_, pressures, pressures, volume_);
    result_.volume_factors_.compute(result_.volume_);
    if (result_.volume_factors_.info() != Eigen::Success) {
      throw NumericalError("films: the volumes of films and junctions cannot be inverted; a film may be too thin");
    }
  }

 private:
  using Entries = std::vector<Eigen::Triplet<double>>;

  /// The displacements of nodes, and flows. The macroscopic motion is taken from the first node: a translation does no
  /// work on an element, and the motion from the origin of the box would add its rounding to the element's forces.
  [[nodiscard]] ElementUnknowns unknowns_of(std::span<const NodeImage> nodes, std::span<const int> flows) const {
    ElementUnknowns unknowns;
    unknowns.macroscopic.setZero(static_cast<Eigen::Index>(2 * nodes.size() + flows.size()), 3);
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      unknowns.macroscopic.middleRows<2>(2 * static_cast<Eigen::Index>(n)) =
          affine_motion(mesh_.place(nodes[n]) - mesh_.place(nodes[0]));
      for (int i = 0; i < 2; ++i) {
        unknowns.numbers.push_back(unknowns_.displacement(nodes[n].grain, nodes[n].number, i));
      }
    }
    unknowns.numbers.insert(unknowns.numbers.end(), flows.begin(), flows.end());
    return unknowns;
  }

  void add_stretch(std::size_t f, int element) {
    const auto matrices = film_element(mesh_.stretch(f, element));
    const std::array flows = {unknowns_.flow(f, element, 0), unknowns_.flow(f, element, 1)};
    const auto unknowns = unknowns_of(mesh_.nodes_of_stretch(f, element), flows);
    const auto pressures = unknowns_.pressures(network_, f, element);
    add_symmetric(shear_, unknowns, matrices.shear);
    add_dilatation(pressures, unknowns, matrices.dilatation);
    for (int a = 0; a < FilmElement::pressures; ++a) {
      for (int b = 0; b < FilmElement::pressures; ++b) {
        const int row = pressures[static_cast<std::size_t>(a)], column = pressures[static_cast<std::size_t>(b)];
        if (row >= column) volume_.emplace_back(row, column, matrices.volume(a, b));
      }
    }
    result_.area_ += matrices.volume.sum();
  }

  /// Where a film flows into a junction, the flow has to turn; at a wall without displacements it flows out freely.
  void add_end(std::size_t f, int end, double end_length) {
    const auto& film = network_.films[f];
    const auto number = film.junctions[static_cast<std::size_t>(end)];
    const auto& junction = network_.junctions[number];
    const int flow = unknowns_.flow(f, end == 0 ? 0 : film.segments - 1, end);
    if (!mesh_.ends_at_wall(f, end)) {
      shear_.emplace_back(flow, flow, 12.0 * end_length);
    } else if (result_.boundary_ == Boundary::traction) {
      const double outward = end == 0 ? -1.0 : 1.0;
      dilatation_.emplace_back(static_cast<int>(number), flow, outward * film.thickness);
      const auto force =
          traction_on(network_.place(junction.corners.front()) - network_.place(junction.corners.back()));
      result_.tractions_.row(flow) += film.direction.transpose() * force;
    }
  }

  void add_face_traction(std::size_t grain, std::size_t face) {
    constexpr std::array<double, 3> shares = {1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0};
    for (int element = 0; element < network_.segments[grain][face]; ++element) {
      std::array<NodeImage, 3> nodes;
      for (int k = 0; k < 3; ++k) {
        nodes[static_cast<std::size_t>(k)] = {grain, unknowns_.node(grain, face, 2 * element + k),
                                              Eigen::Vector2i::Zero()};
      }
      const auto force = traction_on(mesh_.place(nodes[2]) - mesh_.place(nodes[0]));
      for (std::size_t k = 0; k < 3; ++k) add_node_force(nodes[k], shares[k] * force);
    }
  }

  void add_node_force(const NodeImage& node, const Eigen::Matrix<double, 2, 3>& force) {
    for (int i = 0; i < 2; ++i) {
      const int number = unknowns_.displacement(node.grain, node.number, i);
      if (number != Unknowns::held) result_.tractions_.row(number) += force.row(i);
    }
  }

  /// Adds the lower triangle of an element's matrix, and its rows of the macroscopic strains.
  void add_symmetric(Entries& entries, const ElementUnknowns& unknowns, const Eigen::MatrixXd& matrix) const {
    const int strains = unknowns_.count();
    const auto& numbers = unknowns.numbers;
    const Eigen::Matrix<double, Eigen::Dynamic, 3> of_strains = matrix * unknowns.macroscopic;
    const Eigen::Matrix3d of_both = unknowns.macroscopic.transpose() * of_strains;
    for (std::size_t b = 0; b < numbers.size(); ++b) {
      const auto column = static_cast<Eigen::Index>(b);
      if (numbers[b] == Unknowns::held) continue;
      for (std::size_t a = 0; a < numbers.size(); ++a) {
        if (numbers[a] >= numbers[b]) {
          entries.emplace_back(numbers[a], numbers[b], matrix(static_cast<Eigen::Index>(a), column));
        }
      }
      for (int i = 0; i < macroscopic; ++i) entries.emplace_back(strains + i, numbers[b], of_strains(column, i));
    }
    for (int j = 0; j < macroscopic; ++j) {
      for (int i = j; i < macroscopic; ++i) entries.emplace_back(strains + i, strains + j, of_both(i, j));
    }
  }

  void add_dilatation(std::span<const int> pressures, const ElementUnknowns& unknowns, const Eigen::MatrixXd& matrix) {
    const Eigen::Matrix<double, Eigen::Dynamic, 3> of_strains = matrix * unknowns.macroscopic;
    for (std::size_t p = 0; p < pressures.size(); ++p) {
      const auto row = static_cast<Eigen::Index>(p);
      for (std::size_t b = 0; b < unknowns.numbers.size(); ++b) {
        if (unknowns.numbers[b] == Unknowns::held) continue;
        dilatation_.emplace_back(pressures[p], unknowns.numbers[b], matrix(row, static_cast<Eigen::Index>(b)));
      }
      for (int i = 0; i < macroscopic; ++i) {
        dilatation_.emplace_back(pressures[p], unknowns_.count() + i, of_strains(row, i));
      }
    }
  }

  FilmOperator& result_;
  const FilmMesh& mesh_;
  const FilmNetwork& network_;
  const std::vector<GrainMesh>& meshes_;
  const Unknowns& unknowns_;
  Entries grains_, shear_, dilatation_, volume_;
};

FilmOperator::FilmOperator(const FilmProblem& problem) : boundary_(problem.boundary) {
  const FilmMesh mesh(problem);
  Assembly assembly(*this, mesh);
  assembly.add_grains(problem.grain);
  assembly.add_tractions();
  if (boundary_ == Boundary::traction) assembly.add_uniform_gradients();
  assembly.add_films();
  assembly.add_junctions();
  assembly.finish();
}

FilmVector FilmOperator::load_forces(Load load) const {
  if (boundary_ == Boundary::traction) return {0.0, tractions_ * stress_of(load)};
  return {1.0, Eigen::VectorXd::Zero(unknowns())};
}

FilmVector FilmOperator::uniform_strain(Load load) const {
  if (boundary_ != Boundary::traction) return {1.0, Eigen::VectorXd::Zero(unknowns())};
  // Rotated so that the held components are zero: a displacement gradient H with this symmetric part.
  const auto strain = unit_strain<2>(load);
  const double h21 = -strain.yy * held_.y() / held_.x();
  const Eigen::Vector4d gradient(strain.xx, 2.0 * strain.xy - h21, h21, strain.yy);
  return {0.0, by_gradient_ * gradient};
}

Eigen::VectorXd FilmOperator::extended(Load load, const FilmVector& displacement) const {
  Eigen::VectorXd whole(unknowns() + macroscopic);
  whole << displacement.unknowns(), displacement.macroscopic() * strain_of(load);
  return whole;
}

FilmVector FilmOperator::reduced(Load load, const Eigen::VectorXd& forces) const {
  return {strain_of(load).dot(forces.tail<macroscopic>()), forces.head(unknowns())};
}

FilmVector FilmOperator::grain_forces(Load load, const FilmVector& displacement) const {
  return reduced(load, grains_.selfadjointView<Eigen::Lower>() * extended(load, displacement));
}

FilmVector FilmOperator::shear_forces(Load load, const FilmVector& displacement) const {
  return reduced(load, shear_.selfadjointView<Eigen::Lower>() * extended(load, displacement));
}

Eigen::VectorXd FilmOperator::volumetric_strains(Load load, const FilmVector& displacement) const {
  return volume_factors_.solve(dilatation_ * extended(load, displacement));
}

FilmVector FilmOperator::bulk_forces(Load load, const FilmVector& displacement) const {
  return reduced(load, dilatation_.transpose() * volumetric_strains(load, displacement));
}

FilmOperator::Sparse FilmOperator::matrix(const Moduli& binder) const {
  const Sparse stiffness = grains_ + binder.shear * shear_;
  const int count = unknowns(), all = count + pressures();
  Sparse whole(all, all);
  whole.reserve(stiffness.nonZeros() + dilatation_.nonZeros() + volume_.nonZeros());
  for (int column = 0; column < count; ++column) {
    whole.startVec(column);
    for (Sparse::InnerIterator at(stiffness, column); at && at.row() < count; ++at) {
      whole.insertBack(at.row(), column) = at.value();
    }
    for (Sparse::InnerIterator at(dilatation_, column); at; ++at) {
      whole.insertBack(count + at.row(), column) = -binder.bulk * at.value();
    }
  }
  for (int column = 0; column < pressures(); ++column) {
    whole.startVec(count + column);
    for (Sparse::InnerIterator at(volume_, column); at; ++at) {
      whole.insertBack(count + at.row(), count + column) = -binder.bulk * at.value();
    }
  }
  whole.finalize();
  return whole;
}

}  // namespace breccia::films
