#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "films/assembly/film_matrices.hpp"

namespace breccia::films {

/// Force on a line by the stresses xx, yy and xy; `line` has the body on its left.
[[nodiscard]] Eigen::Matrix<double, 2, 3> traction_on(const Eigen::Vector2d& line);

/// Unknowns of an element: their numbers, and the value of each of them in each macroscopic strain.
template <int dim>
struct ElementUnknowns {
  std::vector<int> numbers;
  typename FilmMatrices<dim>::ByStrain macroscopic;
};

/// Work of an element of the binder, of a unit shear modulus, in the uniform strain of Load::shear.
template <int dim>
[[nodiscard]] double work_in_uniform_shear(const ElementUnknowns<dim>& unknowns, const Eigen::MatrixXd& shear);

/// Adds up the matrices of elements of any kind. Entries of an unknown that is held are left out.
template <int dim>
class MatrixAssembly {
 public:
  using Matrices = FilmMatrices<dim>;
  using Position = Eigen::Matrix<double, dim, 1>;

  MatrixAssembly(int unknowns, int pressures);

  void add_grain(const ElementUnknowns<dim>& unknowns, const Eigen::MatrixXd& stiffness);
  void add_shear(const ElementUnknowns<dim>& unknowns, const Eigen::MatrixXd& stiffness);
  /// Adds a resistance to a single unknown, for a unit shear modulus.
  void add_resistance(int unknown, double stiffness);
  void add_dilatation(std::span<const int> pressures, const ElementUnknowns<dim>& unknowns,
                      const Eigen::MatrixXd& matrix);
  /// Adds the volume that a single unknown takes from a pressure.
  void add_outflow(int pressure, int unknown, double volume);
  void add_volume(std::span<const int> pressures, const Eigen::MatrixXd& matrix);
  /// Gives an unknown that belongs to no element a row of its own, in which it is zero.
  void isolate(int unknown) { add_resistance(unknown, 1.0); }
  /// Holds a pressure at zero: its entries, earlier and later ones, give way to a row of its own.
  void hold_pressure(int pressure) { is_pressure_held_[static_cast<std::size_t>(pressure)] = true; }
  void add_content(double content) { result_.content += content; }
  /// Adds the content of a grain of this elasticity, for the strains in Voigt's order.
  template <class Elasticity>
  void add_content_of_grain(double content, const Elasticity& elasticity) {
    add_content(content);
    result_.content_of_grains += content;
    result_.shear_of_grains += content * elasticity(elasticity.rows() - 1, elasticity.cols() - 1);
  }
  /// Adds the forces of the stresses, in Voigt's order, on an unknown.
  void add_traction(int unknown, const Eigen::Matrix<double, 1, Matrices::macroscopic>& forces);
  /// Sets the position, relative to the first node, of the node to whose displacement component an unknown belongs.
  void set_position(int unknown, int component, const Position& position);
  /// Sets the position, relative to the first node, of the node that a traction boundary holds against rotation.
  void set_farthest_held(const Position& position) { result_.farthest_held = position; }

  [[nodiscard]] Matrices finish();

 private:
  using Sparse = typename Matrices::Sparse;
  using Entries = std::vector<Eigen::Triplet<double>>;

  /// A symmetric matrix that is added up: its sum so far, and further entries of its lower triangle; the forces of the
  /// macroscopic strains on the unknowns, and the stiffness of the macroscopic strains.
  struct Part {
    explicit Part(int unknowns);
    void add_up();
    [[nodiscard]] Sparse finish();

    Sparse sum;
    Entries entries;
    typename Matrices::ByStrain of_strains;
    Eigen::Matrix<double, Matrices::macroscopic, Matrices::macroscopic> of_both;
  };

  void leave_out_held_pressures();
  static void add_symmetric(Part& part, const ElementUnknowns<dim>& unknowns, const Eigen::MatrixXd& matrix);

  int unknowns_, pressures_;
  std::vector<bool> is_pressure_held_;
  Matrices result_;
  Part grains_, shear_;
  Entries dilatation_, volume_;
};

}  // namespace breccia::films
